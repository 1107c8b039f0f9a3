// Bytes as the program packs them: base64 of compressed variable-length integers. See
// reports/explorer/Packing.h and framework/support/Bytes.h.

export function fromBase64(text: string): Uint8Array {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
}

export async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
    const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class ByteReader {
    private at = 0;

    constructor(private readonly bytes: Uint8Array) {}

    byte(): number {
        if (this.at >= this.bytes.length) throw new RangeError("the data end too early");
        return this.bytes[this.at++];
    }

    /** A number below 2^53. */
    number(): number {
        let value = 0;
        for (let factor = 1; ; factor *= 128) {
            const next = this.byte();
            value += (next & 0x7f) * factor;
            if (next < 0x80) return value;
        }
    }

    /** Some unsigned number of 32 bits, given as its difference to another (zigzag). */
    difference(expected: number): number {
        const code = this.number();
        return (expected + ((code >>> 1) ^ -(code & 1))) >>> 0;
    }

    get left(): number {
        return this.bytes.length - this.at;
    }
}
