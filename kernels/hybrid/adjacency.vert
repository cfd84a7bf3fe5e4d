// Six corners for the geometry shader: a triangle's, and between them those of its neighbours.   [thesis fig. 26]
#include "hybrid/published.glslh"

void main() { gl_Position = vec4(published_corner(uint(gl_VertexIndex)), 1.0); }
