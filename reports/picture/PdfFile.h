#pragma once
/// \file
/// Finished PDF documents: made reproducible, and put together as vectors.

#include <string>
#include <vector>

namespace mrpp
{

/// A rectangle on a page, in points of 1/72 inch from the bottom left.
struct PdfArea
{
    double left = 0;
    double bottom = 0;
    double width = 0;
    double height = 0;
};

/// The first page of `pdf`, to be placed.
struct PdfPlacement
{
    std::size_t page = 0; ///< of the document, from 0
    PdfArea area;         ///< the drawing keeps its proportions and is centred in it
    const std::string *pdf = nullptr;
};

/// What a document says of itself.
struct PdfInformation
{
    std::string title;
    std::string created; ///< "2026-07-31T12:00:00Z"; empty or anything else: no date
};

/// The same document without dates and with an identity that follows from its contents.
/// Throws DrawingError where it is no PDF.
[[nodiscard]] std::string withoutTimes(const std::string &pdf);

/// Puts drawings onto the pages of a document (as form XObjects: nothing is rasterized, fonts stay
/// text). The same input gives the same bytes. Throws DrawingError.
[[nodiscard]] std::string placeDrawings(const std::string &document,
                                        const std::vector<PdfPlacement> &placements,
                                        const PdfInformation &information);

/// Width and height of the first page in points. Throws DrawingError where it is no PDF.
[[nodiscard]] std::pair<double, double> pageSize(const std::string &pdf);

} // namespace mrpp
