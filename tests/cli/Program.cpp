#include "tests/cli/Program.h"

#include "framework/system/File.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp::test
{

Scratch::Scratch()
{
    std::string name = (std::filesystem::temp_directory_path() / "mrppsim.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("no scratch folder");
    path_ = name;
}

Scratch::~Scratch()
{
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

void Scratch::write(const std::filesystem::path &name, const std::string &contents) const
{
    writeFile(path_ / name, contents);
}

std::string Scratch::read(const std::filesystem::path &name) const
{
    return readFile(path_ / name);
}

bool Scratch::has(const std::filesystem::path &name) const
{
    return std::filesystem::exists(path_ / name);
}

std::map<std::string, std::string> Scratch::tree(const std::filesystem::path &folder) const
{
    std::map<std::string, std::string> files;
    if (!std::filesystem::is_directory(path_ / folder))
        return files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(path_ / folder))
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(path_ / folder).string()] = readFile(entry.path());
    return files;
}

Process::Process(const std::vector<std::string> &words, const Scratch &scratch)
    : out_(scratch.path() / ".stdout"), err_(scratch.path() / ".stderr")
{
    std::vector<char *> arguments;
    for (const std::string &word : words)
        arguments.push_back(const_cast<char *>(word.c_str())); // execvp promises not to change them
    arguments.push_back(nullptr);
    id_ = ::fork();
    if (id_ < 0)
        throw std::runtime_error("fork");
    if (id_ > 0)
        return;
    const int out = ::open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = ::open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (::chdir(scratch.path().c_str()) != 0 || ::dup2(out, STDOUT_FILENO) < 0 ||
        ::dup2(err, STDERR_FILENO) < 0)
        ::_exit(126);
    ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
}

Process::~Process()
{
    if (id_ > 0)
    {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
}

void Process::signal(int number) const
{
    ::kill(id_, number);
}

Outcome Process::wait()
{
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = -1;
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    outcome.out = readFile(out_);
    outcome.err = readFile(err_);
    std::filesystem::remove(out_);
    std::filesystem::remove(err_);
    return outcome;
}

std::vector<std::string> mrppsimWords(std::vector<std::string> words)
{
    words.insert(words.begin(), MRPP_PROGRAM);
    return words;
}

Outcome mrppsim(const std::vector<std::string> &words, const Scratch &scratch)
{
    return Process(mrppsimWords(words), scratch).wait();
}

std::vector<std::vector<std::string>> parseCsv(const std::string &text)
{
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> row;
    std::string cell;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (quoted)
        {
            if (c != '"')
                cell += c;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                cell += text[++i];
            else
                quoted = false;
        }
        else if (c == '"')
            quoted = true;
        else if (c == ',' || c == '\n')
        {
            row.push_back(std::move(cell));
            cell.clear();
            if (c == '\n')
            {
                rows.push_back(std::move(row));
                row.clear();
            }
        }
        else
            cell += c;
    }
    return rows;
}

} // namespace mrpp::test
