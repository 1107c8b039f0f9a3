#pragma once
/// \file
/// Which runs have begun, noted before each begins: a line a run in a file of its own beside the database, as
/// that costs no transaction. What it says is taken over into the database when the store is closed or
/// opened again.

#include "framework/system/Descriptor.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mrpp
{

class BegunRuns
{
public:
    /// \param folder the campaign's; the file is made with the first note
    explicit BegunRuns(const std::filesystem::path &folder) : file_(folder / ".begun") {}

    /// The keys in the file; of a line that was cut short nothing.
    [[nodiscard]] std::vector<std::string> read() const;

    /// Survives the death of this process, but is not forced to the disk. Where the file cannot be written,
    /// nothing is noted: the database will say what is wrong.
    void note(const std::string &runKey);

    /// Removes the file.
    void forget();

private:
    std::filesystem::path file_;
    Descriptor descriptor_;
};

} // namespace mrpp
