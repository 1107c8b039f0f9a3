#pragma once
/// \file
/// Runs the built program as a user would, in a folder of its own.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mrpp::test
{

/// A folder that is gone with the object.
class Scratch
{
public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return path_; }
    void write(const std::filesystem::path &name, const std::string &contents) const;
    [[nodiscard]] std::string read(const std::filesystem::path &name) const;
    [[nodiscard]] bool has(const std::filesystem::path &name) const;

    /// All files below a folder, by their path in it; nothing where there is no such folder.
    [[nodiscard]] std::map<std::string, std::string> tree(const std::filesystem::path &folder = ".") const;

private:
    std::filesystem::path path_;
};

struct Outcome
{
    int code = -1; ///< the exit code; −signal where one ended it
    std::string out;
    std::string err;
};

/// A started process with its output in files of the scratch folder.
class Process
{
public:
    Process(const std::vector<std::string> &words, const Scratch &scratch);
    ~Process();
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;

    void signal(int number) const;
    [[nodiscard]] Outcome wait();

private:
    std::filesystem::path out_;
    std::filesystem::path err_;
    int id_ = -1;
};

/// `mrppsim WORDS…` in the scratch folder.
[[nodiscard]] Outcome mrppsim(const std::vector<std::string> &words, const Scratch &scratch);
/// The words of such a call, for Process.
[[nodiscard]] std::vector<std::string> mrppsimWords(std::vector<std::string> words);

/// Rows of a CSV file, cells with quotes, commas and line ends included.
[[nodiscard]] std::vector<std::vector<std::string>> parseCsv(const std::string &text);

} // namespace mrpp::test
