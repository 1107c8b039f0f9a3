#pragma once
/// \file
/// Rows and cells of quoted CSV that somebody else wrote. Internal to the readers of this folder.

#include "framework/support/Error.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

class CsvReader
{
public:
    /// \param text must outlive the reader
    CsvReader(std::string_view text, std::string file);

    struct Cell
    {
        std::string text;
        SourceLocation where; ///< of its first character
        bool endsRow = false;
    };

    /// The next row; nothing at the end of the text. Blank lines are skipped. Throws ParseError where a
    /// quotation mark is not closed, something stands behind a closed one, or there are more than a thousand
    /// cells.
    std::vector<Cell> row();

private:
    char take();
    Cell cell();

    std::string_view rest_;
    std::string file_;
    std::size_t line_ = 1;
    std::size_t column_ = 1;
};

} // namespace mrpp
