// What scenes are drawn with: a canvas, or an SVG file of the same picture. Sizes are CSS pixels.

/** Colours; what has none is not drawn. */
export interface Paint {
    fill?: string;
    stroke?: string;
    width?: number; // of the stroke
}

export interface Pen {
    clear(width: number, height: number, color: string): void;
    /** Straight lines x1, y1, x2, y2, …. */
    lines(coordinates: ArrayLike<number>, color: string, width: number): void;
    /** One line through all points x, y, …. */
    polyline(coordinates: ArrayLike<number>, color: string, width: number, opacity: number): void;
    circle(x: number, y: number, radius: number, paint: Paint): void;
    square(x: number, y: number, radius: number, paint: Paint): void;
    text(x: number, y: number, text: string, color: string, size: number): void;
    /** A picture whose pixels stay squares. */
    image(picture: HTMLCanvasElement, x: number, y: number, width: number, height: number): void;
}

const kFullTurn = 2 * Math.PI;

export class CanvasPen implements Pen {
    constructor(private readonly context: CanvasRenderingContext2D) {}

    clear(width: number, height: number, color: string): void {
        this.context.fillStyle = color;
        this.context.fillRect(0, 0, width, height);
    }

    lines(coordinates: ArrayLike<number>, color: string, width: number): void {
        const { context } = this;
        context.beginPath();
        for (let i = 0; i < coordinates.length; i += 4) {
            context.moveTo(coordinates[i], coordinates[i + 1]);
            context.lineTo(coordinates[i + 2], coordinates[i + 3]);
        }
        context.strokeStyle = color;
        context.lineWidth = width;
        context.stroke();
    }

    polyline(coordinates: ArrayLike<number>, color: string, width: number, opacity: number): void {
        const { context } = this;
        context.save();
        context.beginPath();
        for (let i = 0; i < coordinates.length; i += 2) context.lineTo(coordinates[i], coordinates[i + 1]);
        context.globalAlpha = opacity;
        context.strokeStyle = color;
        context.lineWidth = width;
        context.lineJoin = "round";
        context.lineCap = "round";
        context.stroke();
        context.restore();
    }

    circle(x: number, y: number, radius: number, paint: Paint): void {
        this.context.beginPath();
        this.context.arc(x, y, radius, 0, kFullTurn);
        this.paint(paint);
    }

    square(x: number, y: number, radius: number, paint: Paint): void {
        this.context.beginPath();
        this.context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
        this.paint(paint);
    }

    text(x: number, y: number, text: string, color: string, size: number): void {
        const { context } = this;
        context.fillStyle = color;
        context.font = `600 ${size}px system-ui, sans-serif`;
        context.textAlign = "center";
        context.textBaseline = "middle";
        context.fillText(text, x, y);
    }

    image(picture: HTMLCanvasElement, x: number, y: number, width: number, height: number): void {
        this.context.imageSmoothingEnabled = width < picture.width;
        this.context.drawImage(picture, x, y, width, height);
    }

    private paint({ fill, stroke, width }: Paint): void {
        const { context } = this;
        if (fill !== undefined) {
            context.fillStyle = fill;
            context.fill();
        }
        if (stroke === undefined) return;
        context.strokeStyle = stroke;
        context.lineWidth = width ?? 1;
        context.stroke();
    }
}

export class SvgPen implements Pen {
    private readonly parts: string[] = [];
    private width = 0;
    private height = 0;

    clear(width: number, height: number, color: string): void {
        this.width = width;
        this.height = height;
        this.add("rect", { width, height, fill: color });
    }

    lines(coordinates: ArrayLike<number>, color: string, width: number): void {
        const at = (i: number): string => `${rounded(coordinates[i])} ${rounded(coordinates[i + 1])}`;
        const path: string[] = [];
        for (let i = 0; i < coordinates.length; i += 4) path.push(`M${at(i)}L${at(i + 2)}`);
        this.add("path", { d: path.join(""), stroke: color, "stroke-width": width });
    }

    polyline(coordinates: ArrayLike<number>, color: string, width: number, opacity: number): void {
        const points = Array.from(coordinates, rounded).join(" ");
        const joined = { "stroke-linejoin": "round", "stroke-linecap": "round" };
        this.add("polyline", {
            points,
            fill: "none",
            stroke: color,
            "stroke-width": width,
            opacity,
            ...joined,
        });
    }

    circle(x: number, y: number, r: number, paint: Paint): void {
        this.add("circle", { cx: x, cy: y, r, ...attributesOf(paint) });
    }

    square(x: number, y: number, r: number, paint: Paint): void {
        this.add("rect", { x: x - r, y: y - r, width: 2 * r, height: 2 * r, ...attributesOf(paint) });
    }

    text(x: number, y: number, text: string, color: string, size: number): void {
        const middle = { "text-anchor": "middle", "dominant-baseline": "central" };
        this.add("text", { x, y, "font-size": size, fill: color, ...middle }, text);
    }

    image(picture: HTMLCanvasElement, x: number, y: number, width: number, height: number): void {
        const look = { preserveAspectRatio: "none", "image-rendering": "pixelated" };
        this.add("image", { x, y, width, height, ...look, href: picture.toDataURL() });
    }

    /** The file. */
    svg(title: string): string {
        const [width, height] = [rounded(this.width), rounded(this.height)];
        const font = 'font-family="system-ui, sans-serif" font-weight="600"';
        return (
            `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
            `viewBox="0 0 ${width} ${height}" ${font}>` +
            `<title>${escaped(title)}</title>\n${this.parts.join("\n")}\n</svg>\n`
        );
    }

    private add(name: string, attributes: Record<string, string | number>, text?: string): void {
        const words = Object.entries(attributes).map(
            ([key, value]) => ` ${key}="${typeof value === "number" ? rounded(value) : escaped(value)}"`,
        );
        this.parts.push(
            `<${name}${words.join("")}${text === undefined ? "/>" : `>${escaped(text)}</${name}>`}`,
        );
    }
}

const rounded = (value: number): string => String(Math.round(value * 100) / 100);

function attributesOf({ fill, stroke, width }: Paint): Record<string, string | number> {
    return { fill: fill ?? "none", ...(stroke === undefined ? {} : { stroke, "stroke-width": width ?? 1 }) };
}

function escaped(text: string): string {
    return text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
}
