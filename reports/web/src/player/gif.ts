// Animated GIFs (GIF89a), frame by frame. The palette is taken from the first frames; colours that it lacks
// become the nearest that it has.

class BitWriter {
    readonly bytes: number[] = [];
    private block: number[] = []; // of at most 255 bytes
    private bits = 0;
    private count = 0;

    write(code: number, width: number): void {
        this.bits |= code << this.count;
        for (this.count += width; this.count >= 8; this.count -= 8) {
            this.put(this.bits & 255);
            this.bits >>>= 8;
        }
    }

    finish(): void {
        if (this.count > 0) this.put(this.bits & 255);
        this.flush();
        this.bytes.push(0);
    }

    private put(byte: number): void {
        this.block.push(byte);
        if (this.block.length === 255) this.flush();
    }

    private flush(): void {
        if (this.block.length > 0) this.bytes.push(this.block.length, ...this.block);
        this.block = [];
    }
}

/** LZW of indices of 8 bits, as sub-blocks. */
export function compressIndices(indices: Uint8Array): number[] {
    const kClear = 256;
    const kEnd = 257;
    const kMostCodes = 4096;
    const writer = new BitWriter();
    let table = new Map<number, number>(); // prefix · 256 + next → code
    let next = kEnd + 1;
    let width = 9;
    writer.write(kClear, width);
    let prefix = indices[0];
    for (let i = 1; i < indices.length; ++i) {
        const key = prefix * 256 + indices[i];
        const known = table.get(key);
        if (known !== undefined) {
            prefix = known;
            continue;
        }
        writer.write(prefix, width);
        if (next === kMostCodes) {
            writer.write(kClear, width);
            table = new Map();
            next = kEnd + 1;
            width = 9;
        } else {
            table.set(key, next);
            if (next === 1 << width) ++width;
            ++next;
        }
        prefix = indices[i];
    }
    if (indices.length > 0) writer.write(prefix, width);
    writer.write(kEnd, width);
    writer.finish();
    return writer.bytes;
}

export class GifWriter {
    private readonly parts: Uint8Array[] = [];
    private readonly palette: number[]; // 0xrrggbb, 256 of them
    private readonly nearest = new Map<number, number>();

    /** \param samples frames (RGBA) whose colours count */
    constructor(
        private readonly width: number,
        private readonly height: number,
        samples: Uint8ClampedArray[],
    ) {
        this.palette = commonColors(samples);
        const word = (value: number): number[] => [value & 255, value >> 8];
        this.put([...ascii("GIF89a"), ...word(width), ...word(height), 0xf7, 0, 0]);
        this.put(this.palette.flatMap((color) => [color >> 16, (color >> 8) & 255, color & 255]));
        this.put([0x21, 0xff, 11, ...ascii("NETSCAPE2.0"), 3, 1, 0, 0, 0]); // for ever
    }

    /** \param hundredths of a second */
    addFrame(pixels: Uint8ClampedArray, hundredths: number): void {
        const indices = new Uint8Array(this.width * this.height);
        for (let i = 0; i < indices.length; ++i)
            indices[i] = this.indexOf((pixels[4 * i] << 16) | (pixels[4 * i + 1] << 8) | pixels[4 * i + 2]);
        const word = (value: number): number[] => [value & 255, value >> 8];
        this.put([0x21, 0xf9, 4, 0, ...word(hundredths), 0, 0]);
        this.put([0x2c, 0, 0, 0, 0, ...word(this.width), ...word(this.height), 0, 8]);
        this.put(compressIndices(indices));
    }

    finish(): Blob {
        return new Blob([...this.parts, new Uint8Array([0x3b])] as BlobPart[], { type: "image/gif" });
    }

    private put(bytes: number[]): void {
        this.parts.push(Uint8Array.from(bytes));
    }

    private indexOf(color: number): number {
        const known = this.nearest.get(color);
        if (known !== undefined) return known;
        let best = 0;
        let least = Infinity;
        this.palette.forEach((other, i) => {
            const red = (color >> 16) - (other >> 16);
            const green = ((color >> 8) & 255) - ((other >> 8) & 255);
            const blue = (color & 255) - (other & 255);
            const distance = 3 * red * red + 6 * green * green + blue * blue;
            if (distance < least) {
                least = distance;
                best = i;
            }
        });
        this.nearest.set(color, best);
        return best;
    }
}

function ascii(text: string): number[] {
    return [...text].map((letter) => letter.charCodeAt(0));
}

/** The most frequent colours, of those that differ by more than a shade. */
function commonColors(samples: Uint8ClampedArray[]): number[] {
    const counts = new Map<number, [number, number]>(); // shade → count, a colour of it
    for (const pixels of samples)
        for (let i = 0; i < pixels.length; i += 4) {
            const color = (pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2];
            const entry = counts.get(color & 0xf8f8f8);
            if (entry) ++entry[0];
            else counts.set(color & 0xf8f8f8, [1, color]);
        }
    const colors = [...counts.values()]
        .sort((a, b) => b[0] - a[0])
        .slice(0, 256)
        .map(([, color]) => color);
    while (colors.length < 256) colors.push(0);
    return colors;
}
