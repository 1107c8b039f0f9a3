#include "reports/drawing/GraphvizGraph.h"

#include "reports/drawing/PdfFile.h"
#include "reports/drawing/Text.h"

#include <cstdlib>
#include <graphviz/gvc.h>
#include <mutex>

namespace mrpp
{

namespace
{

/// Graphviz keeps state of its own for the whole process, so its lock is the process's as well. The context
/// is never freed: the text plugin remembers the last font of a context beyond the context's end.
struct Graphviz
{
    std::mutex lock;
    GVC_t *context = gvContext();
};

Graphviz &graphviz()
{
    static Graphviz library;
    return library;
}

// The C interface takes text as `char *` but never writes to it.
char *text(const char *constant)
{
    return const_cast<char *>(constant);
}
char *text(const std::string &constant)
{
    return const_cast<char *>(constant.c_str());
}

} // namespace

struct GraphvizGraph::State
{
    std::lock_guard<std::mutex> lock;
    GVC_t *context = nullptr;
    Agraph_t *graph = nullptr;
    std::vector<Agnode_t *> nodes;
    std::vector<Agedge_t *> edges;

    State() : lock(graphviz().lock)
    {
        agseterr(AGMAX); // what went wrong shows in return values
        context = graphviz().context;
        graph = agopen(text("drawing"), Agstrictundirected, nullptr);
    }
    ~State() { agclose(graph); }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    /// Layouts live as long as this.
    struct Layout
    {
        State &state;
        Layout(State &drawn, const char *engine) : state(drawn)
        {
            if (gvLayout(state.context, state.graph, engine) != 0)
                throw DrawingError(std::string("Graphviz' layout engine ") + engine + " failed");
        }
        ~Layout() { gvFreeLayout(state.context, state.graph); }
        Layout(const Layout &) = delete;
        Layout &operator=(const Layout &) = delete;
    };

    std::string render(const char *format)
    {
        const Layout layout(*this, "nop2");
        char *bytes = nullptr;
        unsigned int size = 0;
        const int failure = gvRenderData(context, graph, format, &bytes, &size);
        std::string drawing = bytes == nullptr ? std::string() : std::string(bytes, size);
        gvFreeRenderData(bytes);
        if (failure != 0)
            throw DrawingError(std::string("Graphviz cannot draw ") + format);
        return drawing;
    }
};

GraphvizGraph::GraphvizGraph() : state_(std::make_unique<State>()) {}
GraphvizGraph::~GraphvizGraph() = default;

void GraphvizGraph::setDefault(Kind kind, const char *name, const std::string &value)
{
    const int type = kind == Kind::graph ? AGRAPH : kind == Kind::node ? AGNODE : AGEDGE;
    agattr(state_->graph, type, text(name), text(value));
}

std::size_t GraphvizGraph::addNode()
{
    const std::string name = std::to_string(state_->nodes.size());
    state_->nodes.push_back(agnode(state_->graph, text(name), 1));
    return state_->nodes.size() - 1;
}

std::size_t GraphvizGraph::addEdge(std::size_t a, std::size_t b)
{
    state_->edges.push_back(agedge(state_->graph, state_->nodes[a], state_->nodes[b], nullptr, 1));
    return state_->edges.size() - 1;
}

void GraphvizGraph::setNode(std::size_t node, const char *name, const std::string &value)
{
    agset(state_->nodes[node], text(name), text(value));
}

void GraphvizGraph::setEdge(std::size_t edge, const char *name, const std::string &value)
{
    agset(state_->edges[edge], text(name), text(value));
}

std::vector<Point> GraphvizGraph::arrange(const char *engine)
{
    // The engines draw from the C library's generators, wherever an earlier caller left them.
    constexpr unsigned int kSeed = 1;
    std::srand(kSeed);
    ::srand48(kSeed);
    const State::Layout layout(*state_, engine);
    std::vector<Point> positions;
    positions.reserve(state_->nodes.size());
    for (Agnode_t *node : state_->nodes)
        positions.push_back({ND_coord(node).x, ND_coord(node).y, 0});
    return positions;
}

Picture GraphvizGraph::renderPinned(int resolution)
{
    constexpr const char *kPoints = "72";
    Picture picture;
    setDefault(Kind::graph, "dpi", std::to_string(resolution));
    picture.png = state_->render("png");
    setDefault(Kind::graph, "dpi", kPoints);
    picture.pdf = state_->render("pdf");
    picture.svg = state_->render("svg");
    verify(picture);
    picture.pdf = withoutTimes(picture.pdf);
    return picture;
}

std::string GraphvizGraph::escaped(const std::string &label)
{
    std::string result;
    for (const char c : manyLines(label))
        if (c == '\\')
            result += "\\\\";
        else if (c == '&')
            result += "&amp;";
        else if (c == '\n')
            result += "\\n";
        else
            result += c;
    return result;
}

} // namespace mrpp
