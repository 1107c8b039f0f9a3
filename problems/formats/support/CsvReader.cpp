#include "problems/formats/support/CsvReader.h"

#include "problems/formats/support/TextReader.h"

namespace mrpp
{

CsvReader::CsvReader(std::string_view text, std::string file)
    : rest_(withoutByteOrderMark(text)), file_(std::move(file))
{}

std::vector<CsvReader::Cell> CsvReader::row()
{
    constexpr std::size_t mostCells = 1000;
    std::vector<Cell> cells;
    while (!rest_.empty() && (rest_.front() == '\n' || rest_.front() == '\r'))
        take();
    while (!rest_.empty() && (cells.empty() || !cells.back().endsRow))
    {
        if (cells.size() == mostCells)
            throw ParseError({file_, line_, column_},
                             "the row has more than " + std::to_string(mostCells) + " cells");
        cells.push_back(cell());
    }
    return cells;
}

char CsvReader::take()
{
    const char c = rest_.front();
    rest_.remove_prefix(1);
    line_ += c == '\n' ? 1 : 0;
    column_ = c == '\n' ? 1 : column_ + 1;
    return c;
}

CsvReader::Cell CsvReader::cell()
{
    Cell cell;
    const bool quoted = rest_.front() == '"';
    const SourceLocation quote{file_, line_, column_};
    if (quoted)
        take();
    cell.where = {file_, line_, column_};
    while (quoted)
    {
        if (rest_.empty())
            throw ParseError(quote, "this quotation mark is never closed");
        const char c = take();
        if (c == '"' && (rest_.empty() || rest_.front() != '"'))
            break;
        if (c == '"')
            take();
        cell.text += c;
    }
    while (!rest_.empty())
    {
        const std::size_t column = column_;
        const char c = take();
        if (c == ',')
            return cell;
        if (c == '\n')
            break;
        if (quoted && c != '\r')
            throw ParseError({file_, line_, column},
                             "expected a comma or the line's end behind the quotation mark");
        if (c != '\r')
            cell.text += c;
    }
    cell.endsRow = true;
    return cell;
}

} // namespace mrpp
