// What scenes are drawn with: a canvas, or an SVG file of the same picture. Sizes are CSS pixels.

export interface Pen {
  clear(width: number, height: number, color: string): void;
  /** Straight lines x1, y1, x2, y2, …. */
  lines(coordinates: ArrayLike<number>, color: string, width: number): void;
  /** One line through all points x, y, …. */
  polyline(coordinates: ArrayLike<number>, color: string, width: number, opacity: number): void;
  circle(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void;
  square(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void;
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
    context.beginPath();
    for (let i = 0; i < coordinates.length; i += 2) context.lineTo(coordinates[i], coordinates[i + 1]);
    context.globalAlpha = opacity;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.lineJoin = "round";
    context.lineCap = "round";
    context.stroke();
    context.globalAlpha = 1;
  }

  circle(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void {
    const { context } = this;
    context.beginPath();
    context.arc(x, y, radius, 0, kFullTurn);
    this.paint(fill, stroke, width);
  }

  square(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void {
    const { context } = this;
    if (fill !== null && stroke === null) {
      context.fillStyle = fill;
      context.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
      return;
    }
    context.beginPath();
    context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
    this.paint(fill, stroke, width);
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

  private paint(fill: string | null, stroke: string | null, width: number): void {
    const { context } = this;
    if (fill !== null) {
      context.fillStyle = fill;
      context.fill();
    }
    if (stroke === null) return;
    context.strokeStyle = stroke;
    context.lineWidth = width;
    context.stroke();
  }
}

const rounded = (value: number): string => String(Math.round(value * 100) / 100);

export class SvgPen implements Pen {
  private readonly parts: string[] = [];
  private width = 0;
  private height = 0;

  clear(width: number, height: number, color: string): void {
    this.width = width;
    this.height = height;
    this.parts.push(`<rect width="${rounded(width)}" height="${rounded(height)}" fill="${color}"/>`);
  }

  lines(coordinates: ArrayLike<number>, color: string, width: number): void {
    const path: string[] = [];
    for (let i = 0; i < coordinates.length; i += 4)
      path.push(
        `M${rounded(coordinates[i])} ${rounded(coordinates[i + 1])}L${rounded(coordinates[i + 2])} ${rounded(coordinates[i + 3])}`,
      );
    this.parts.push(`<path d="${path.join("")}" stroke="${color}" stroke-width="${rounded(width)}"/>`);
  }

  polyline(coordinates: ArrayLike<number>, color: string, width: number, opacity: number): void {
    const points = Array.from(coordinates, rounded).join(" ");
    this.parts.push(
      `<polyline points="${points}" fill="none" stroke="${color}" stroke-width="${rounded(width)}" opacity="${opacity}" stroke-linejoin="round" stroke-linecap="round"/>`,
    );
  }

  circle(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void {
    this.parts.push(
      `<circle cx="${rounded(x)}" cy="${rounded(y)}" r="${rounded(radius)}"${paint(fill, stroke, width)}/>`,
    );
  }

  square(x: number, y: number, radius: number, fill: string | null, stroke: string | null, width: number): void {
    const side = rounded(2 * radius);
    this.parts.push(
      `<rect x="${rounded(x - radius)}" y="${rounded(y - radius)}" width="${side}" height="${side}"${paint(fill, stroke, width)}/>`,
    );
  }

  text(x: number, y: number, text: string, color: string, size: number): void {
    this.parts.push(
      `<text x="${rounded(x)}" y="${rounded(y)}" font-size="${rounded(size)}" fill="${color}" text-anchor="middle" dominant-baseline="central">${escaped(text)}</text>`,
    );
  }

  image(picture: HTMLCanvasElement, x: number, y: number, width: number, height: number): void {
    this.parts.push(
      `<image x="${rounded(x)}" y="${rounded(y)}" width="${rounded(width)}" height="${rounded(height)}" preserveAspectRatio="none" image-rendering="pixelated" href="${picture.toDataURL()}"/>`,
    );
  }

  /** The file. */
  svg(title: string): string {
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${rounded(this.width)}" height="${rounded(this.height)}" ` +
      `viewBox="0 0 ${rounded(this.width)} ${rounded(this.height)}" font-family="system-ui, sans-serif" font-weight="600">` +
      `<title>${escaped(title)}</title>\n${this.parts.join("\n")}\n</svg>\n`
    );
  }
}

function paint(fill: string | null, stroke: string | null, width: number): string {
  return ` fill="${fill ?? "none"}"${stroke === null ? "" : ` stroke="${stroke}" stroke-width="${rounded(width)}"`}`;
}

function escaped(text: string): string {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
}
