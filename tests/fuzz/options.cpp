// The command line: arguments as a process gets them, each ended by a NUL, parsed as the program parses them,
// without running a verb; and the values that verbs parse themselves.
#include "casegen/demo_scene.h"
#include "casegen/readings.h"
#include "cli/app.h"
#include "cli/parse.h"
#include "cli/view.h"
#include "tests/fuzz/target.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace gnomon;

/// A message is on one line if what it quotes is: main sees to the rest.
bool is_one_line(const std::string& text) { return text.find('\n') == text.npos; }
bool are_one_line(const std::vector<std::string>& texts) { return std::ranges::all_of(texts, is_one_line); }

void parse_alone(const std::string& text) {
    fuzzing::is_read([&] { cli::parse_vector(text, "--option"); }, is_one_line(text));
    fuzzing::is_read([&] { cli::parse_size(text, "--option"); }, is_one_line(text));
    fuzzing::is_read([&] { cli::parse_seed(text); }, is_one_line(text));
    Readings readings;
    if (fuzzing::is_read([&] { readings = parse_readings({text}); }, is_one_line(text))) to_string(readings);
}

/// The options of a view, all the way to a camera and a light.
void look(const std::vector<std::string>& arguments) {
    static const Scene scene = demo_scene();
    cli::ViewOptions options;
    CLI::App app;
    cli::add_view_options(app, options);
    app.allow_extras();
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError&) {
        return;
    }
    fuzzing::is_read(
        [&] {
            const cli::View view = cli::view_of(options, 256, scene);
            REQUIRE(view.settings.width > 0 && view.settings.height > 0);
            for (int k = 0; k < 3; ++k) REQUIRE(std::isfinite(view.camera.position[k]));
        },
        are_one_line(arguments));
}

/// The program's parser, made once: it forgets what it has parsed at the next parse, and making it takes
/// longer.
struct Program {
    cli::Common common;
    int exit_code = 0;
    std::unique_ptr<CLI::App> app = cli::make_app(common, exit_code, "");

    Program() {
        app->parse_complete_callback([] { throw CLI::Success(); }); // all is parsed, and no verb has run
    }
};

} // namespace

FUZZ_TARGET(options) {
    std::vector<std::string> arguments;
    std::string_view rest = fuzzing::text_of(data, size);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\0'), rest.size());
        std::string argument(rest.substr(0, end));
        parse_alone(argument);
        arguments.push_back(std::move(argument));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    look(arguments);
    static Program program;
    const std::unique_ptr<CLI::App>& app = program.app;
    if (!arguments.empty() &&
        !fuzzing::is_read([&] { cli::require_verb(arguments.front()); }, is_one_line(arguments.front())))
        return 0;
    try {
        app->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) { // what main prints
        REQUIRE(!are_one_line(arguments) || is_one_line(error.what()));
    }
    return 0;
}
