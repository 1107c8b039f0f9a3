#include "reports/picture/PdfFile.h"

#include "reports/picture/Picture.h"

#include <cstdio>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace mrpp
{

namespace
{

void load(QPDF &document, const std::string &bytes)
{
    document.setSuppressWarnings(true);
    document.processMemoryFile("drawing", bytes.data(), bytes.size());
}

std::string save(QPDF &document)
{
    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.write();
    const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char *>(bytes->getBuffer()), bytes->getSize()};
}

/// "D:20260731120000Z" of "2026-07-31T12:00:00Z"; nothing of anything else.
std::string pdfDate(const std::string &iso)
{
    const std::string shape = "dddd-dd-ddTdd:dd:dd";
    if (iso.size() < shape.size())
        return {};
    std::string date = "D:";
    for (std::size_t i = 0; i < shape.size(); ++i)
    {
        const bool isDigit = iso[i] >= '0' && iso[i] <= '9';
        if (shape[i] == 'd' ? !isDigit : iso[i] != shape[i])
            return {};
        if (isDigit)
            date += iso[i];
    }
    return date + "Z";
}

void setInformation(QPDF &document, const PdfInformation &information)
{
    QPDFObjectHandle dictionary = QPDFObjectHandle::newDictionary();
    if (!information.title.empty())
        dictionary.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(information.title));
    dictionary.replaceKey("/Creator", QPDFObjectHandle::newString("mrppsim"));
    if (const std::string date = pdfDate(information.created); !date.empty())
        dictionary.replaceKey("/CreationDate", QPDFObjectHandle::newString(date));
    document.getTrailer().replaceKey("/Info", document.makeIndirectObject(dictionary));
}

/// Runs `work` and turns qpdf's errors into ours.
template <class Work>
auto guarded(Work &&work)
{
    try
    {
        return work();
    }
    catch (const QPDFExc &error)
    {
        throw DrawingError(std::string("a PDF cannot be read: ") + error.what());
    }
}

QPDFPageObjectHelper firstPage(QPDF &document)
{
    const std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(document).getAllPages();
    if (pages.empty())
        throw DrawingError("a PDF has no pages");
    return pages.front();
}

} // namespace

std::string withoutTimes(const std::string &pdf)
{
    return guarded(
        [&]
        {
            QPDF document;
            load(document, pdf);
            setInformation(document, {});
            return save(document);
        });
}

std::pair<double, double> pageSize(const std::string &pdf)
{
    return guarded(
        [&]
        {
            QPDF document;
            load(document, pdf);
            const auto box = firstPage(document).getTrimBox().getArrayAsRectangle();
            return std::pair{box.urx - box.llx, box.ury - box.lly};
        });
}

std::string placeDrawings(const std::string &document, const std::vector<PdfPlacement> &placements,
                          const PdfInformation &information)
{
    return guarded(
        [&]
        {
            QPDF target;
            load(target, document);
            std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(target).getAllPages();
            std::vector<std::unique_ptr<QPDF>> sources; // alive until the target is written
            for (const PdfPlacement &placement : placements)
            {
                sources.push_back(std::make_unique<QPDF>());
                load(*sources.back(), *placement.pdf);
                QPDFObjectHandle form =
                    target.copyForeignObject(firstPage(*sources.back()).getFormXObjectForPage());
                QPDFPageObjectHelper &page = pages.at(placement.page);
                QPDFObjectHandle resources = page.getAttribute("/Resources", true);
                if (!resources.isDictionary())
                {
                    resources = QPDFObjectHandle::newDictionary();
                    page.getObjectHandle().replaceKey("/Resources", resources);
                }
                resources.mergeResources(QPDFObjectHandle::parse("<< /XObject << >> >>"));
                int suffix = 1;
                const std::string name = resources.getUniqueResourceName("/Drawing", suffix);
                resources.getKey("/XObject").replaceKey(name, form);
                const PdfArea &area = placement.area;
                const QPDFObjectHandle::Rectangle place(area.left, area.bottom, area.left + area.width,
                                                        area.bottom + area.height);
                const std::string contents = page.placeFormXObject(form, name, place);
                page.addPageContents(QPDFObjectHandle::newStream(&target, "q\n"), true);
                page.addPageContents(QPDFObjectHandle::newStream(&target, "\nQ\n" + contents), false);
            }
            setInformation(target, information);
            return save(target);
        });
}

} // namespace mrpp
