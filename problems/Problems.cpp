#include "problems/Problems.h"

#include "problems/FullyControlled.h"
#include "problems/OneFactor.h"
#include "problems/PublicBenchmark.h"
#include "problems/SmallBenchmark.h"
#include "problems/formats/Exchange.h"
#include "problems/formats/Formats.h"
#include "problems/generators/Generators.h"

namespace mrpp
{

void registerProblems(Catalog &catalog)
{
    catalog.problems.add<FullyControlled>("fully_controlled", "a graph and an instance from files");
    catalog.problems.add<SmallBenchmark>("small_benchmark", "a small critical problem, built in");
    catalog.problems.add<PublicBenchmark>("public_benchmark",
                                          "a MovingAI map with random robots or those of a scenario");
    catalog.problems.add("fg_vr", "one factor: a fixed generated graph, variable robots",
                         [] { return std::make_unique<OneFactor>(OneFactor::Varies::robots); });
    catalog.problems.add("fr_vg", "one factor: a fixed share of robots, a variable generated graph",
                         [] { return std::make_unique<OneFactor>(OneFactor::Varies::graph); });
    registerGenerators(catalog);
    for (FileFormat &format : fileFormats())
        catalog.formats.push_back(std::move(format));
    catalog.files = std::make_shared<const Exchange>();
}

} // namespace mrpp
