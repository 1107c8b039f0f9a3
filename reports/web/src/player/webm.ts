// WebM files of one video: EBML elements as Matroska defines them (RFC 9559), as few as players need.

export interface VideoChunk {
    milliseconds: number; // since the beginning
    isKey: boolean; // can be shown without the chunks before it
    data: Uint8Array;
}

export interface VideoFormat {
    codec: "V_VP8" | "V_VP9";
    width: number;
    height: number;
    milliseconds: number; // of the whole
}

/** A cluster of chunks for each key frame, all of which can be sought. */
export function webmFile(format: VideoFormat, chunks: VideoChunk[]): Blob {
    const header = element(
        0x1a45dfa3,
        element(0x4286, unsigned(1)),
        element(0x42f7, unsigned(1)),
        element(0x42f2, unsigned(4)), // bytes of an identifier
        element(0x42f3, unsigned(8)), // and of a size
        element(0x4282, ascii("webm")),
        element(0x4287, unsigned(2)),
        element(0x4285, unsigned(2)),
    );
    const kNanosecondsAMillisecond = 1_000_000;
    const info = element(
        0x1549a966,
        element(0x2ad7b1, unsigned(kNanosecondsAMillisecond)),
        element(0x4489, real(format.milliseconds)),
        element(0x4d80, ascii("MRPPSim")),
        element(0x5741, ascii("MRPPSim")),
    );
    const size = element(0xe0, element(0xb0, unsigned(format.width)), element(0xba, unsigned(format.height)));
    const kVideo = 1;
    const track = element(
        0xae,
        element(0xd7, unsigned(1)),
        element(0x73c5, unsigned(1)),
        element(0x83, unsigned(kVideo)),
        element(0x86, ascii(format.codec)),
        size,
    );
    const tracks = element(0x1654ae6b, track);
    const clusters = clustersOf(chunks);
    const before = info.length + tracks.length;
    const cues = cuesOf(clusters, before + cuesOf(clusters, 0).length);
    const segment = element(0x18538067, info, tracks, cues, ...clusters.map(({ bytes }) => bytes));
    return new Blob([header, segment] as BlobPart[], { type: "video/webm" });
}

interface Cluster {
    milliseconds: number;
    bytes: Uint8Array;
}

function clustersOf(chunks: VideoChunk[]): Cluster[] {
    const groups: VideoChunk[][] = [];
    for (const chunk of chunks)
        if (chunk.isKey || groups.length === 0) groups.push([chunk]);
        else groups[groups.length - 1].push(chunk);
    return groups.map((group) => {
        const [{ milliseconds }] = group;
        const blocks = group.map((chunk) => {
            const head = new DataView(new ArrayBuffer(4));
            head.setUint8(0, 0x81); // the first track
            head.setInt16(1, chunk.milliseconds - milliseconds);
            head.setUint8(3, chunk.isKey ? 0x80 : 0);
            return element(0xa3, new Uint8Array(head.buffer), chunk.data);
        });
        return { milliseconds, bytes: element(0x1f43b675, element(0xe7, unsigned(milliseconds)), ...blocks) };
    });
}

/** Where the clusters begin, in bytes of the segment; of the same length wherever that is. */
function cuesOf(clusters: Cluster[], first: number): Uint8Array {
    let place = first;
    const points = clusters.map(({ milliseconds, bytes }) => {
        const positions = element(0xb7, element(0xf7, unsigned(1)), element(0xf1, unsigned(place)));
        place += bytes.length;
        return element(0xbb, element(0xb3, unsigned(milliseconds)), positions);
    });
    return element(0x1c53bb6b, ...points);
}

function element(identifier: number, ...contents: Uint8Array[]): Uint8Array {
    const name: number[] = [];
    for (let rest = identifier; rest > 0; rest = Math.floor(rest / 256)) name.unshift(rest % 256);
    const size = unsigned(contents.reduce((sum, { length }) => sum + length, 0));
    size[0] = 0x01; // seven more bytes of size
    const parts = [Uint8Array.from(name), size, ...contents];
    const bytes = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const part of parts) {
        bytes.set(part, at);
        at += part.length;
    }
    return bytes;
}

function unsigned(value: number): Uint8Array {
    const view = new DataView(new ArrayBuffer(8));
    view.setBigUint64(0, BigInt(Math.round(value)));
    return new Uint8Array(view.buffer);
}

function real(value: number): Uint8Array {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, value);
    return new Uint8Array(view.buffer);
}

function ascii(text: string): Uint8Array {
    return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}
