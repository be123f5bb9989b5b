import { act, cleanup, render } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test } from "vitest";
import type { CameraSightEvent } from "../api/model";
import { passesAxe } from "../kit/testing/control";
import { NowSeen } from "./NowSeen";
import { receive } from "./sight";
import { changed, hand, seen } from "./testing/seen";

beforeEach(() => receive(changed("on")));
afterEach(() => {
  cleanup();
  receive(changed("off"));
});

const shown = (sight: CameraSightEvent, progress = 0) => {
  receive(sight);
  return render(<NowSeen progress={progress} />);
};

describe("what the camera sees, in words", () => {
  test("is the letter and how sure it is", async () => {
    const { container, getByTestId } = shown(seen(hand({ best: "B", second: "R" })));
    expect(getByTestId("reading").dataset.kind).toBe("sure");
    expect(container.textContent).toContain("B");
    expect(container.textContent).toContain("97%");
    expect(container.textContent).toContain("ou R");
    await passesAxe(container);
  });

  test("is doubt between two letters", async () => {
    const doubt = hand({ best: "F", second: "T", confidence: 0.5, sure: false });
    const { container } = shown(seen(doubt));
    expect(container.textContent).toBe("Ainda não é certo:F ou T?");
    await passesAxe(container);
  });

  test.each([
    ["no hand", seen(), "Mostrem a mão"],
    ["no letter", seen(hand({ best: "", sure: false })), "A letra ainda não foi reconhecida"],
    ["two signs", seen(hand({ best: "A" }), hand({ best: "B" })), "Há duas mãos: mostrem uma só"],
  ])("says what to do about: %s", (kind, sight, words) => {
    const { container, getByTestId } = shown(sight);
    expect(getByTestId("reading").dataset.kind).toBe(kind);
    expect(container.textContent).toBe(words);
  });

  test("asks for a hand that is kept still while the sign becomes steady, and shows how near it is", () => {
    const { getByRole, container } = shown(seen(hand()), 0.6);
    expect(getByRole("progressbar").getAttribute("aria-valuenow")).toBe("60");
    expect(container.textContent).toContain("Mantenham a mão parada");
  });

  test("is what is wrong with the picture, unless a sign is seen in it all the same", () => {
    const { container, getByTestId } = shown(seen());
    act(() => receive(changed("failed", "camera_dark")));
    expect(getByTestId("camera-trouble").textContent).toMatch(/^Está escuro demais/);
    act(() => receive(seen(hand())));
    expect(container.textContent).toContain("97%");
  });

  test("is nothing where there is no picture", () => {
    const { container } = shown(seen(hand()));
    act(() => receive(changed("failed", "camera_missing")));
    expect(container.textContent).toBe("");
  });
});
