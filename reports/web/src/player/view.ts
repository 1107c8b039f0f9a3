// How a solution is looked at: everything that its picture depends on but the time.
import type { Theme } from "../page/theme";
import type { Camera } from "./camera";

export interface Marks {
    goals: boolean;
    trails: boolean;
    blocks: boolean; // and isthmuses
    heat: Float64Array | null; // a number a vertex
    heatMost: number; // which has the ramp's last colour
    followed: number; // robot, or −1
    marked: number[]; // robots of the event at this time
    markColor: string;
}

export interface View extends Marks {
    camera: Camera;
    theme: Theme;
    width: number; // CSS pixels
    height: number;
}
