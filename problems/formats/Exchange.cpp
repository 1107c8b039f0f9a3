#include "problems/formats/Exchange.h"

#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/Formats.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphText.h"
#include "problems/formats/Kei18.h"
#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/Surynek.h"
#include "problems/formats/VetandXml.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// Whether a result of Kei18's programs says that they found nothing; some write half a solution then.
bool saysUnsolved(std::string_view text)
{
    constexpr std::string_view kUnsolved = "solved=0";
    const std::size_t at = text.find(kUnsolved);
    return at == 0 || (at != std::string_view::npos && text[at - 1] == '\n');
}

} // namespace

std::string Exchange::extensionOf(const std::string &format) const
{
    for (const FileFormat &known : fileFormats())
        if (known.name == format)
            return known.extensions.substr(0, known.extensions.find(' '));
    return {};
}

void Exchange::writeGraph(const std::string &format, const Graph &graph,
                          const std::filesystem::path &file) const
{
    writeFile(file, format == "movingai_map" ? formatMovingAiMap(gridMapOf(graph))
                    : format == "dimacs"     ? formatDimacs(graph)
                    : format == "edge_list"  ? formatEdgeList(graph)
                                             : formatGraphMl(graph));
}

void Exchange::writeInstance(const std::string &format, const Instance &instance,
                             const std::filesystem::path &graphFile, const std::filesystem::path &file) const
{
    if (format == "cpf")
        return writeFile(file, formatCpf(instance));
    if (format == "kei18_instance")
        return writeFile(file, formatKei18Instance(instance, std::filesystem::absolute(graphFile).string()));
    if (format == "libmrp_instance")
        return writeFile(file, formatLibMrpInstance(instance));
    if (format == "libmrp_map")
        return writeFile(file, formatLibMrpInstance(instance, {}, LibMrpForm::map));
    if (format == "libmrp_roadmap")
        return writeFile(file, formatLibMrpInstance(instance, {}, LibMrpForm::roadmap));
    if (format == "vetand_instance")
        return writeFile(file, formatVetandInstance(instance));
    saveInstance(file, instance, graphFile,
                 format == "movingai_scenario" ? InstanceForm::scenario : InstanceForm::text);
}

std::optional<Schedule> Exchange::readSolution(const std::string &format, const Instance &instance,
                                               const std::filesystem::path &file) const
{
    const std::string text = readFile(file);
    const FormatId found = formatOf(file, text);
    const bool isUnanswered = format == "vetand_result" && found == FormatId::vetandInstance;
    if (!format.empty() && nameOf(found) != format && !isUnanswered)
        throw ParseError({file.string()}, "this is no " + format + " but " + describe(found, text));
    if (found == FormatId::kei18Result && saysUnsolved(text))
        return std::nullopt;
    try
    {
        return scheduleOf(loadSolution(file, instance), instance);
    }
    catch (const NoSolution &)
    {
        return std::nullopt;
    }
}

} // namespace mrpp
