// What a campaign has done, on disk, a line per unit: written before the next unit begins, read again if the
// campaign was interrupted. A line that was cut short by the interruption is as good as none.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gnomon::fuzz {

class Journal {
public:
    struct Line {
        std::uint64_t unit = 0;
        std::string text;
    };

    Journal() = default; ///< keeps nothing
    /// Opens or begins the file. `campaign`: a word for all that its units depend on (campaign_key). Throws
    /// Error if it cannot, if the file is no journal or that of another campaign, or if somebody else is
    /// writing to it.
    Journal(const std::filesystem::path& path, const std::string& campaign);
    /// Removes the journal, if there is one, of whatever campaign. Throws Error if the file is none, or in
    /// use.
    static void discard(const std::filesystem::path& path);

    const std::vector<Line>& lines() const { return lines_; } ///< of the run that was interrupted
    /// Throws Error (disk full).
    void add(const Line& line);
    /// The campaign is over: removes the file.
    void finish();

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    using File = std::unique_ptr<std::FILE, Close>;

private:
    void write(const std::string& text);

    std::filesystem::path path_;
    File file_; ///< locked
    std::vector<Line> lines_;
};

} // namespace gnomon::fuzz
