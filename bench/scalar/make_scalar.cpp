// Writes the C++ file behind scalar.h: every numbered family's kernels, once per assembly, each in a
// namespace of its own. GLSL is C++ with GLM but for a few words, which are replaced here.
//
//     make_scalar KERNELS OUT.cpp
#include "bench/scalar/scalar.h"
#include "casegen/catalogue.h"
#include "casegen/standalone.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <regex>

namespace gnomon {
namespace {

/// `Edge(a, b)` to `Edge{a, b}`, for every struct that the text defines.
std::string braced(std::string text) {
    static const std::regex structs("struct (\\w+) \\{");
    std::vector<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), structs), end; it != end; ++it)
        names.push_back((*it)[1]);
    for (const std::string& name : names)
        for (std::size_t at = text.find(name + "("); at != text.npos; at = text.find(name + "(", at + 1)) {
            if (at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) || text[at - 1] == '_'))
                continue;
            std::size_t open = at + name.size(), close = open;
            for (int depth = 0; close < text.size(); ++close) {
                depth += text[close] == '(' ? 1 : text[close] == ')' ? -1 : 0;
                if (depth == 0) break;
            }
            text[open] = '{';
            text[close] = '}';
        }
    return text;
}

std::string to_cpp(const std::string& glsl) {
    static const std::vector<std::pair<std::regex, const char*>> words{
        {std::regex("#(version|extension).*\n"), "\n"},
        {std::regex("//[^\n]*"), ""},
        {std::regex("(^|[^\\w.])(\\d+\\.\\d*|\\.\\d+|\\d+(?=[eE]))([eE][+-]?\\d+)?(?![\\w.])"), "$1$2$3f"},
        {std::regex("\\.([xyzw]{2,4}|[rgba]{2,4})\\b"), ".$1()"},
        {std::regex("\\b(in)?out (\\w+) "), "$2& "},
        {std::regex("([(,] ?)in (\\w+) "), "$1$2 "},
        {std::regex("\\bprecise "), ""},
    };
    std::string text = glsl;
    for (const auto& [from, to] : words) text = std::regex_replace(text, from, to);
    return braced(text);
}

bool reads_the_edge_only(const Case& decision) {
    for (const Parameter& p : decision.parameters)
        if (p.name != "entering" && p.name != "sides" && p.name != "type" && p.name != "dominant")
            return false;
    return true;
}

struct Output {
    std::string text, table;
    int spaces = 0;

    void add(const Family& family, const glsl::Sources& sources, const std::string& name,
             const Case* decision = nullptr) {
        const std::string prefix = identifier(family), space = fmt::format("{}_{}", prefix, ++spaces);
        std::string includes = fmt::format("#include <{}/cases>\n", family.name);
        if (decision) includes += fmt::format("#include \"{}.glsl\"\n", decision->name);
        const Case* visibility = find_kernel(family, "visibility");
        if (visibility) includes += fmt::format("#include \"{}.glsl\"\n", visibility->name);
        std::string members, reads, arguments;
        std::size_t value = 0;
        for (const CaseParameter& p : case_parameters(family, {})) {
            members += fmt::format("    {} {};\n", p.type, p.name);
            const bool two = p.type.ends_with('2');
            reads += two ? fmt::format(", {}(in.values[{}], in.values[{}])", p.type, value, value + 1)
                         : fmt::format(", static_cast<{}>(in.values[{}])", p.type, value);
            value += two ? 2 : 1;
            arguments += fmt::format(", s.{}", p.name);
        }
        std::string number = "s.number";
        if (decision) {
            std::vector<std::string> of_edge;
            for (const Parameter& p : decision->parameters)
                of_edge.push_back("s.edge." + (p.name == "entering" ? "lit" : p.name));
            number = fmt::format("{}({})", function_name(*decision), fmt::join(of_edge, ", "));
        }
        text += fmt::format(
            R"(
namespace {space} {{
{kernels}
#line 1 "{space}"
thread_local const Mask* mask = nullptr;
bool lit(ivec2 texel) {{ return mask->lit(texel.x, texel.y); }}
struct Sample {{
    uint number;
    Edge edge;
{members}}};
std::shared_ptr<void> prepare(std::span<const scalar::Input> inputs) {{
    auto samples = std::make_shared<std::vector<Sample>>();
    for (const scalar::Input& in : inputs)
        samples->push_back({{in.number, Edge{{in.edge.sides, in.edge.reach, in.edge.type, in.edge.dominant, in.edge.lit}}{reads}}});
    return samples;
}}
std::vector<float> evaluate(const void* prepared) {{
    std::vector<float> results;
    for (const Sample& s : *static_cast<const std::vector<Sample>*>(prepared))
        results.push_back({prefix}_case({number}, s.edge{arguments}));
    return results;
}}
float sum(const void* prepared) {{
    float result = 0;
    for (const Sample& s : *static_cast<const std::vector<Sample>*>(prepared))
        result += {prefix}_case({number}, s.edge{arguments});
    return result;
}}
float visibility(const Mask& over, ivec2 texel, vec2 p) {{
    mask = &over;
    return {visibility};
}}
}}
)",
            fmt::arg("space", space), fmt::arg("kernels", to_cpp(glsl::expand(sources, includes, space))),
            fmt::arg("members", members), fmt::arg("reads", reads), fmt::arg("prefix", prefix),
            fmt::arg("number", number), fmt::arg("arguments", arguments),
            fmt::arg("visibility", visibility ? function_name(*visibility) + "(texel, p)" : "0.0f"));
        table += fmt::format("        {{\"{0}\", \"{1}\", {2}::prepare, {2}::evaluate, {2}::sum, "
                             "{2}::visibility}},\n",
                             family.name, name, space);
    }
};

void write(const std::filesystem::path& kernels, const std::filesystem::path& out) {
    Output output;
    for (const Family& family : catalogue()) {
        if (numbered_cases(family).empty()) continue;
        const std::vector<unsigned> frequent = scalar::corpus_order(family);
        const std::vector<unsigned> rarest(frequent.rbegin(), frequent.rend());
        const auto add = [&](const std::string& name, const Assembly& assembly,
                             const Case* decision = nullptr) {
            glsl::Sources sources = kernel_sources(kernels);
            sources.generated[family.name + "/cases"] = assembled(family, assembly);
            output.add(family, sources, name, decision);
        };
        add("switch", {});
        const Case* decision = find_kernel(family, "decision");
        if (decision && reads_the_edge_only(*decision)) add("switch behind the decision list", {}, decision);
        add("document order", {Variant::document_order});
        add("frequent first", {Variant::frequency_order, frequent});
        add("rarest first", {Variant::frequency_order, rarest});
        add("tree", {Variant::branch_tree, frequent});
        add("branchless", {Variant::branchless});
        add("table", {Variant::table});
    }
    write_file(out,
               fmt::format("// Written by make_scalar from the kernels.\n#define GLM_FORCE_SWIZZLE\n"
                           "#include \"bench/scalar/scalar.h\"\n\n#include <glm/glm.hpp>\n\n"
                           "namespace gnomon {{\nnamespace {{\nusing namespace glm;\nusing uint = unsigned;\n"
                           "{}\n}}\n#line 1 \"scalar::kernels\"\n"
                           "const std::vector<scalar::Kernel>& scalar::kernels() {{\n"
                           "    static const std::vector<Kernel> all{{\n{}    }};\n    return all;\n}}\n}}\n",
                           output.text, output.table));
}

} // namespace
} // namespace gnomon

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "make_scalar KERNELS OUT.cpp\n");
        return 2;
    }
    try {
        gnomon::write(argv[1], argv[2]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_scalar: {}\n", error.what());
        return 2;
    }
}
