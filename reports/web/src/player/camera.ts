// Which part of the graph is shown: screen = graph · scale + offset, in CSS pixels.

export interface Point {
    x: number;
    y: number;
}

export interface Box {
    left: number;
    top: number;
    right: number;
    bottom: number;
}

export function boundsOf(x: Float32Array, y: Float32Array): Box {
    const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
    for (let v = 0; v < x.length; ++v) {
        box.left = Math.min(box.left, x[v]);
        box.right = Math.max(box.right, x[v]);
        box.top = Math.min(box.top, y[v]);
        box.bottom = Math.max(box.bottom, y[v]);
    }
    return x.length > 0 ? box : { left: 0, top: 0, right: 0, bottom: 0 };
}

export class Camera {
    scale = 1;
    offsetX = 0;
    offsetY = 0;
    private fitted = 1;

    /** Shows the whole box in the middle, with a margin around it that is given in the graph's unit. */
    fit(box: Box, width: number, height: number, margin: number): void {
        const across = box.right - box.left + 2 * margin;
        const down = box.bottom - box.top + 2 * margin;
        this.scale = this.fitted = Math.min(width / across, height / down);
        this.offsetX = width / 2 - ((box.left + box.right) / 2) * this.scale;
        this.offsetY = height / 2 - ((box.top + box.bottom) / 2) * this.scale;
    }

    /** Makes everything larger by a factor; the point under (x, y) stays. */
    zoom(factor: number, x: number, y: number): void {
        const scale = Math.min(Math.max(this.scale * factor, this.fitted / 4), this.fitted * 400);
        const change = scale / this.scale;
        this.offsetX = x - (x - this.offsetX) * change;
        this.offsetY = y - (y - this.offsetY) * change;
        this.scale = scale;
    }

    pan(dx: number, dy: number): void {
        this.offsetX += dx;
        this.offsetY += dy;
    }

    center(x: number, y: number, width: number, height: number): void {
        this.offsetX = width / 2 - x * this.scale;
        this.offsetY = height / 2 - y * this.scale;
    }

    screenX(x: number): number {
        return x * this.scale + this.offsetX;
    }

    screenY(y: number): number {
        return y * this.scale + this.offsetY;
    }

    screen({ x, y }: Point): Point {
        return { x: this.screenX(x), y: this.screenY(y) };
    }

    /** What is seen, in the graph's numbers. */
    seen(width: number, height: number): Box {
        return {
            left: -this.offsetX / this.scale,
            top: -this.offsetY / this.scale,
            right: (width - this.offsetX) / this.scale,
            bottom: (height - this.offsetY) / this.scale,
        };
    }

    copy(other: Camera): void {
        this.scale = other.scale;
        this.offsetX = other.offsetX;
        this.offsetY = other.offsetY;
    }
}
