// A page of as many runs as you like, out of a small one: every run of it over and over, with other numbers
// and keys.
import { randomBytes } from "node:crypto";
import { deflateSync, inflateSync } from "node:zlib";

interface ColumnData {
    name: string;
    numbers?: (number | null)[];
    texts?: string[];
    rows?: number[];
}

export function enlarged(page: string, count: number): string {
    const block = (id: string): RegExp => new RegExp(`( id="${id}">)([^<]*)(</script>)`);
    const about = JSON.parse(page.match(block("explorer"))![2]);
    const runs = JSON.parse(
        inflateSync(Buffer.from(page.match(block("runs"))![2], "base64")).toString("utf8"),
    );
    const before: number = about.runCount;
    const indices = Array.from({ length: count }, (_, run) => run);
    const columns = (runs.columns as ColumnData[]).map((column): ColumnData => {
        if (column.numbers) {
            const numbers = column.numbers;
            const vary = (value: number | null, run: number): number | null =>
                value === null
                    ? null
                    : Number.isInteger(value)
                      ? value + (run % 97)
                      : value * (1 + (run % 89) / 88);
            return { ...column, numbers: indices.map((run) => vary(numbers[run % before], run)) };
        }
        if (["run_key", "instance_fingerprint", "solution_fingerprint"].includes(column.name))
            return { ...column, texts: indices.map(() => randomBytes(16).toString("hex")), rows: indices };
        return { ...column, rows: indices.map((run) => column.rows![run % before]) };
    });
    const packed = deflateSync(
        JSON.stringify({ columns, absences: { texts: [""], rows: indices.map(() => 0) } }),
        { level: 6 },
    );
    const description = JSON.stringify({ ...about, runCount: count, cases: [], playable: [] }).replaceAll(
        "<",
        "\\u003c",
    );
    const replace = (text: string, id: string, data: string): string =>
        text.replace(block(id), (_, start, __, end) => `${start}${data}${end}`);
    return replace(replace(page, "explorer", description), "runs", packed.toString("base64"));
}
