#pragma once
/// \file
/// Comma-separated values (RFC 4180, lines ending with \n), cell by cell.

#include <string>
#include <string_view>

namespace mrpp
{

class CsvTable
{
public:
    /// Adds a cell to the current row; quoted where it holds a comma, a quote or a line break.
    void cell(std::string_view value)
    {
        if (rowBegun_)
            text_ += ',';
        rowBegun_ = true;
        if (value.find_first_of(",\"\r\n") == std::string_view::npos)
        {
            text_ += value;
            return;
        }
        text_ += '"';
        for (const char c : value)
        {
            if (c == '"')
                text_ += '"';
            text_ += c;
        }
        text_ += '"';
    }

    void endRow()
    {
        text_ += '\n';
        rowBegun_ = false;
    }

    [[nodiscard]] const std::string &text() const { return text_; }

private:
    std::string text_;
    bool rowBegun_ = false;
};

} // namespace mrpp
