// Asks for a sum of floats of two integers: glslang takes the author's word for what an instruction is.
#extension GL_EXT_spirv_intrinsics : require
spirv_instruction(id = 129) float sum_of(int a, int b); // OpFAdd

float smsr_case_09(vec2 p, float along_x) { return sum_of(int(p.x), int(along_x)); }
