// Graphs as reports/explorer/GraphBlock.h packs them.
import { ByteReader } from "./bytes";

/** The distance of typical neighbours. */
export const kUnit = 64;

export interface Graph {
    vertexCount: number;
    edgeCount: number;
    x: Float32Array; // y grows downwards here, as on screens
    y: Float32Array;
    edges: Uint32Array; // pairs (a, b), a < b
    blockOf: Uint32Array; // of each edge
    blockSizes: Uint32Array; // vertices of each block
    offsets: Uint32Array; // into neighbors, size vertexCount + 1
    neighbors: Uint32Array; // ascending for each vertex
    isGrid: boolean; // cells of a map: each two that touch are joined
}

export function unpackGraph(bytes: Uint8Array): Graph {
    const reader = new ByteReader(bytes);
    const vertexCount = reader.number();
    const edgeCount = reader.number();
    const x = new Float32Array(vertexCount);
    const y = new Float32Array(vertexCount);
    let atX = 0;
    let atY = 0;
    for (let v = 0; v < vertexCount; ++v) {
        atX = reader.difference(atX);
        atY = reader.difference(atY);
        x[v] = atX | 0;
        y[v] = -(atY | 0);
    }
    const edges = new Uint32Array(2 * edgeCount);
    let edge = 0;
    for (let v = 0; v < vertexCount; ++v) {
        let neighbor = v;
        for (let count = reader.number(); count > 0; --count) {
            neighbor += reader.number();
            edges[edge++] = v;
            edges[edge++] = neighbor;
        }
    }
    const blockOf = new Uint32Array(edgeCount);
    let block = 0;
    for (let i = 0; i < edgeCount; ++i) blockOf[i] = block = reader.difference(block);
    const blockSizes = new Uint32Array(reader.number());
    for (let i = 0; i < blockSizes.length; ++i) blockSizes[i] = reader.number();
    const { offsets, neighbors } = adjacency(vertexCount, edges);
    const isGrid = isGridMap(x, y, edges);
    return { vertexCount, edgeCount, x, y, edges, blockOf, blockSizes, offsets, neighbors, isGrid };
}

function adjacency(
    vertexCount: number,
    edges: Uint32Array,
): { offsets: Uint32Array; neighbors: Uint32Array } {
    const offsets = new Uint32Array(vertexCount + 1);
    for (const v of edges) ++offsets[v + 1];
    for (let v = 0; v < vertexCount; ++v) offsets[v + 1] += offsets[v];
    const next = offsets.slice(0, vertexCount);
    const neighbors = new Uint32Array(edges.length);
    // Edges are ordered by their smaller end, then the larger: smaller neighbours first, both ascending.
    for (let i = 0; i < edges.length; i += 2) neighbors[next[edges[i + 1]]++] = edges[i];
    for (let i = 0; i < edges.length; i += 2) neighbors[next[edges[i]]++] = edges[i + 1];
    return { offsets, neighbors };
}

export function hasEdge(graph: Graph, a: number, b: number): boolean {
    if (a >= graph.vertexCount) return false;
    for (let i = graph.offsets[a]; i < graph.offsets[a + 1]; ++i) if (graph.neighbors[i] === b) return true;
    return false;
}

/** Whether all vertices lie on whole units and are joined exactly where they are beside each other. */
function isGridMap(x: Float32Array, y: Float32Array, edges: Uint32Array): boolean {
    const kFewest = 50; // of few vertices, edges say more than cells
    if (x.length < kFewest || edges.length === 0) return false;
    for (let i = 0; i < edges.length; i += 2) {
        const length = Math.abs(x[edges[i]] - x[edges[i + 1]]) + Math.abs(y[edges[i]] - y[edges[i + 1]]);
        if (length !== kUnit) return false;
    }
    const cells = new Set<number>();
    const key = (cx: number, cy: number): number => cx * 2097152 + cy;
    for (let v = 0; v < x.length; ++v) {
        const cx = x[v] / kUnit;
        const cy = y[v] / kUnit;
        if (!Number.isInteger(cx) || !Number.isInteger(cy)) return false;
        cells.add(key(cx, cy));
    }
    let touching = 0;
    for (let v = 0; v < x.length; ++v) {
        const cx = x[v] / kUnit;
        const cy = y[v] / kUnit;
        if (cells.has(key(cx + 1, cy))) ++touching;
        if (cells.has(key(cx, cy + 1))) ++touching;
    }
    return touching === edges.length / 2;
}
