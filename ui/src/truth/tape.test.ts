import { describe, expect, it } from "vitest";
import { entryOf, isWrong, poseOf, type TapeEntry, turned } from "./tape";

const BELIEVED = { x_m: 1.05, y_m: -0.02, heading_rad: 1.5 };

const entry = (part: Partial<TapeEntry> = {}): TapeEntry => ({
  ...entryOf(null, BELIEVED, "pt-BR"),
  ...part,
});
const distance = (text: string, isNegative = false) => ({ text, isNegative });

describe("what was measured with a tape", () => {
  it("is no pose before both distances are typed", () => {
    expect(poseOf(entry())).toBeNull();
    expect(poseOf(entry({ forward: distance("102") }))).toBeNull();
  });

  it("is a pose in metres, to the right and behind negative", () => {
    const measured = entry({ forward: distance("102,5", true), sideways: distance("3", true) });
    expect(poseOf(measured)).toMatchObject({ tick: null, x_m: -1.025, y_m: -0.03, sigma_m: 0.01 });
  });

  it("proposes the sides and the heading that the robot believes, and no distance", () => {
    const { forward, sideways, headingDeg } = entry();
    expect([forward, sideways]).toEqual([distance(""), distance("", true)]);
    expect(headingDeg).toBeCloseTo(90);
  });

  it("is surer of a heading in degrees than of one chosen by its drawing", () => {
    const both = { forward: distance("0"), sideways: distance("0") };
    const typed = poseOf(entry({ ...both, isHeadingTyped: true }))?.sigma_rad ?? 0;
    const drawn = poseOf(entry(both))?.sigma_rad ?? 0;
    expect(typed).toBeCloseTo((2 * Math.PI) / 180);
    expect(drawn).toBeGreaterThan(2 * typed);
  });

  it.each(["-3", "5001", "abc", "1.2.3"])("refuses %s", (text) => {
    expect(isWrong(distance(text))).toBe(true);
    expect(poseOf(entry({ forward: distance(text), sideways: distance("0") }))).toBeNull();
  });

  it("is shown again as it was typed", () => {
    const typed = entry({
      forward: distance("102,5"),
      sideways: distance("3", true),
      headingDeg: -12,
    });
    expect(entryOf(poseOf(typed), BELIEVED, "pt-BR")).toEqual(typed);
    expect(entryOf(poseOf(typed), BELIEVED, "en").forward.text).toBe("102.5");
  });
});

describe("turning the drawing", () => {
  it("goes by whole steps and round the circle", () => {
    expect(turned(1, 0)).toBeCloseTo(15);
    expect(turned(-1, 7)).toBeCloseTo(-15);
    expect(turned(1, 180)).toBeCloseTo(-165);
  });
});
