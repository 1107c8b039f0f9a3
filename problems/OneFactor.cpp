#include "problems/OneFactor.h"

#include "framework/Catalog.h"
#include "framework/support/Error.h"
#include "problems/SolvableInstance.h"
#include "problems/WellFormedInstance.h"

#include <cassert>

namespace mrpp
{

OneFactor::OneFactor(Varies varies) : varies_(varies)
{
    declareParam("graph", graph_, "", "a generator and its parameters: {GENERATOR: {parameter: value}}");
    declareParam("solvable", solvable_, "", "draw only instances that have a solution");
    declareParam("well_formed", wellFormed_, "",
                 "draw only well-formed instances: each robot has a path around all other starts and goals");
}

void OneFactor::configure(const Config &settings, const ProblemContext &context)
{
    generator_.reset();
    graph_.clear();
    Problem::configure(settings, context);
    if (generator_)
        return;
    const Config *name = settings.isMap() ? settings.find("graph") : &settings;
    if (name == nullptr || graph_.empty())
        throw PlanError(settings.where(),
                        "a one-factor model needs a 'graph', as in 'graph: {grid: {side: 8}}'");
    chooseGenerator(graph_, name->where(), Config::map({}, name->where()));
}

bool OneFactor::configureMap(const std::string &parameter, const Config &value)
{
    if (parameter != "graph")
        return false;
    if (value.entries().size() != 1)
        throw PlanError(value.entries().empty() ? value.where() : value.entries()[1].where,
                        "'graph' names one generator with its parameters, as in 'graph: {grid: {side: 8}}'");
    const Config::Entry &entry = value.entries().front();
    const bool empty = entry.value.kind() == Config::Kind::empty;
    chooseGenerator(entry.key, entry.where, empty ? Config::map({}, entry.where) : entry.value);
    return true;
}

void OneFactor::chooseGenerator(const std::string &family, const SourceLocation &where,
                                const Config &settings)
{
    assert(context().catalog != nullptr);
    generator_ = makeGenerator(*context().catalog, family);
    if (!generator_)
    {
        const auto names = generatorNames(*context().catalog);
        std::string hint = suggestion(family, names);
        if (hint.empty())
            for (const std::string &name : names)
                hint += (hint.empty() ? "; known: " : ", ") + name;
        throw PlanError(where, "there is no generator '" + family + "'" + hint);
    }
    if (settings.isMap())
        for (const Config::Entry &entry : settings.entries())
            if (RobotCount::key(entry.key))
                throw PlanError(entry.where, "'" + entry.key + "' stands beside 'graph', not in it");
    graph_ = family;
    generator_->configure(settings, context());
}

Instance OneFactor::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed) const
{
    if (wellFormed_)
        return wellFormedInstance(std::move(graph), robots, seed);
    return solvable_ ? solvableInstance(std::move(graph), robots, seed)
                     : generator_->makeInstance(std::move(graph), robots, seed);
}

} // namespace mrpp
