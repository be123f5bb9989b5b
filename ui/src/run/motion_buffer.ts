import type { Pose } from "./reducer";

interface Sample {
  tick: number;
  pose: Pose;
}

const TICK_MS = 1000 / 30;
/** The picture runs this far behind, so that there is always a sample to move towards. */
const DELAY_TICKS = 1.5;
const KEPT = 12;

/** Smooths 30 samples a second into a position for every frame of the screen. */
export class MotionBuffer {
  private samples: Sample[] = [];
  /** Arrival time of tick 0, as the promptest samples tell it. */
  private origin = Number.NaN;

  private tickMs = TICK_MS;

  /** Samples come faster or slower from now on. */
  setSpeed(factor: number): void {
    this.tickMs = TICK_MS / factor;
    this.origin = Number.NaN;
  }

  push(tick: number, pose: Pose, now: number): void {
    const last = this.samples.at(-1);
    if (last && tick <= last.tick) this.reset();
    this.samples.push({ tick, pose });
    if (this.samples.length > KEPT) this.samples.shift();
    const origin = now - tick * this.tickMs;
    // a sample may come late, never early; the slow drift follows a clock that runs differently
    if (!(origin >= this.origin) || origin - this.origin > 500) this.origin = origin;
    else this.origin += (origin - this.origin) * 0.02;
  }

  /** Forgets everything and stands at `pose`. */
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

/** The pose at `part` of the way, turning the short way round. */
export function between(a: Pose, b: Pose, part: number): Pose {
  const turn = Math.atan2(Math.sin(b.yaw - a.yaw), Math.cos(b.yaw - a.yaw));
  return {
    x: a.x + (b.x - a.x) * part,
    y: a.y + (b.y - a.y) * part,
    yaw: a.yaw + turn * part,
  };
}
