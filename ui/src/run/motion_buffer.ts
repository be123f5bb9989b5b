import type { Pose } from "./reducer";

interface Sample {
  tick: number;
  pose: Pose;
}

const TICK_MS = 1000 / 30;
/** Delay of the drawn pose, so that there is always a later sample to interpolate to. */
const DELAY_TICKS = 1.5;
const MAX_SAMPLES = 12;

/** Interpolates 30 samples a second to a pose for every animation frame. */
export class MotionBuffer {
  private samples: Sample[] = [];
  /** Arrival time of tick 0, estimated from the samples with the smallest delay. */
  private origin = Number.NaN;

  private tickMs = TICK_MS;

  /** Sets the rate of the samples relative to real time. */
  setSpeed(factor: number): void {
    this.tickMs = TICK_MS / factor;
    this.origin = Number.NaN;
  }

  push(tick: number, pose: Pose, now: number): void {
    const last = this.samples.at(-1);
    if (last && tick <= last.tick) this.reset();
    this.samples.push({ tick, pose });
    if (this.samples.length > MAX_SAMPLES) this.samples.shift();
    const origin = now - tick * this.tickMs;
    // a sample can arrive late, never early; the slow correction follows clock drift
    if (!(origin >= this.origin) || origin - this.origin > 500) this.origin = origin;
    else this.origin += (origin - this.origin) * 0.02;
  }

  /** Clears the buffer; the robot is at rest at `pose`. */
  reset(pose?: Pose): void {
    this.samples = pose ? [{ tick: -1, pose }] : [];
    this.origin = Number.NaN;
  }

  at(now: number): Pose | null {
    const last = this.samples.at(-1);
    if (!last) return null;
    const tick = (now - this.origin) / this.tickMs - DELAY_TICKS;
    if (!(tick < last.tick)) return last.pose;
    const next = this.samples.findIndex((sample) => sample.tick > tick);
    const after = this.samples[next];
    const before = this.samples[next - 1];
    if (!after || !before) return after?.pose ?? last.pose;
    return between(before.pose, after.pose, (tick - before.tick) / (after.tick - before.tick));
  }
}

/** Interpolates two poses; the heading takes the shorter rotation. */
export function between(a: Pose, b: Pose, part: number): Pose {
  const turn = Math.atan2(Math.sin(b.yaw - a.yaw), Math.cos(b.yaw - a.yaw));
  return {
    x: a.x + (b.x - a.x) * part,
    y: a.y + (b.y - a.y) * part,
    yaw: a.yaw + turn * part,
  };
}
