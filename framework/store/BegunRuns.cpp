#include "framework/store/BegunRuns.h"

#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace mrpp
{

std::vector<std::string> BegunRuns::read() const
{
    std::vector<std::string> keys;
    std::ifstream file(file_);
    for (std::string line; std::getline(file, line) && !file.eof();)
        keys.push_back(line);
    return keys;
}

void BegunRuns::note(const std::string &runKey)
{
    constexpr mode_t kAsTheUmaskSays = 0666;
    if (descriptor_.number() < 0)
        descriptor_ =
            Descriptor(::open(file_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, kAsTheUmaskSays));
    const std::string line = runKey + "\n";
    [[maybe_unused]] const ssize_t written = ::write(descriptor_.number(), line.data(), line.size());
}

void BegunRuns::forget()
{
    descriptor_.close();
    std::error_code error;
    std::filesystem::remove(file_, error);
}

} // namespace mrpp
