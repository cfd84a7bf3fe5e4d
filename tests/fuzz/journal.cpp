// Journals of interrupted campaigns, and what their lines say.
#include "casegen/fuzz/journal.h"
#include "casegen/fuzz/message.h"
#include "tests/fuzz/target.h"

FUZZ_TARGET(journal) {
    using namespace gnomon;
    static const fuzzing::InputFile file("campaign.journal");
    const std::filesystem::path& path = file.write(fuzzing::text_of(data, size));
    std::vector<fuzz::Journal::Line> lines;
    fuzzing::is_read([&] {
        fuzz::Journal journal(path, "campaign");
        lines = journal.lines();
        journal.add({7, "{}"});
    });
    if (lines.empty()) return 0;
    REQUIRE(fuzz::Journal(path, "campaign").lines().size() == lines.size() + 1);
    for (const fuzz::Journal::Line& line : lines) fuzzing::is_read([&] { fuzz::parse_reply(line.text); });
    return 0;
}
