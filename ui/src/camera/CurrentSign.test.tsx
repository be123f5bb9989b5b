import { act, cleanup, render } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test } from "vitest";
import type { CameraSightEvent } from "../api/model";
import { passesAxe } from "../kit/testing/control";
import { CurrentSign } from "./CurrentSign";
import { receive } from "./sight";
import { changed, hand, numberOf, sightOf } from "./testing/camera_events";

beforeEach(() => receive(changed("on")));
afterEach(() => {
  cleanup();
  receive(changed("off"));
});

const shown = (sight: CameraSightEvent, progress = 0) => {
  receive(sight);
  return render(<CurrentSign progress={progress} />);
};

describe("what the camera sees, in words", () => {
  test("is the letter and how sure it is", async () => {
    const { container, getByTestId } = shown(sightOf(hand({ best: "B", second: "R" })));
    expect(getByTestId("reading").dataset.kind).toBe("sure");
    expect(container.textContent).toContain("B");
    expect(container.textContent).toContain("97%");
    expect(container.textContent).toContain("ou R");
    await passesAxe(container);
  });

  test("is doubt between two letters", async () => {
    const unsureHand = hand({ best: "F", second: "T", confidence: 0.5, sure: false });
    const { container } = shown(sightOf(unsureHand));
    expect(container.textContent).toBe("Ainda não é certo:F ou T?");
    await passesAxe(container);
  });

  test.each([
    ["no hand", sightOf(), "Mostrem a mão"],
    ["no letter", sightOf(hand({ best: "", sure: false })), "A letra ainda não foi reconhecida"],
    [
      "two signs",
      sightOf(hand({ best: "A" }), hand({ best: "B" })),
      "Há duas mãos: mostrem uma só",
    ],
  ])("says what to do about: %s", (kind, sight, text) => {
    const { container, getByTestId } = shown(sight);
    expect(getByTestId("reading").dataset.kind).toBe(kind);
    expect(container.textContent).toBe(text);
  });

  test.each([
    [
      numberOf({ sure: false, confidence: 0.6 }),
      "Ainda não é certo. Levantem bem os dedos:3 ou 4?",
    ],
    [{ ...numberOf({ best: "" }), hands: [] }, "Mostrem uma ou duas mãos"],
    [numberOf({ best: "" }), "O número ainda não foi reconhecido"],
  ])("is the doubt between two numbers, and what to do, where a number is waited for", (sight, text) => {
    receive(sight);
    const { container } = render(<CurrentSign what="number" progress={0} />);
    expect(container.textContent).toBe(text);
  });

  test("is the number of raised fingers", async () => {
    receive(numberOf());
    const { container, getByTestId } = render(<CurrentSign what="number" progress={0.5} />);
    expect(getByTestId("reading").dataset.kind).toBe("sure");
    expect(container.querySelector(".reading__letter")?.textContent).toBe("3");
    expect(container.textContent).toContain("Mantenham as mãos paradas");
    expect(container.querySelector(".visually-hidden")?.textContent).toMatch(/^Número 3, com /);
    await passesAxe(container);
  });

  test("asks for a hand that is kept still while the sign becomes steady, and shows how near it is", () => {
    const { getByRole, container } = shown(sightOf(hand()), 0.6);
    expect(getByRole("progressbar").getAttribute("aria-valuenow")).toBe("60");
    expect(container.textContent).toContain("Mantenham a mão parada");
  });

  test("is what is wrong with the picture, unless a sign is seen in it all the same", () => {
    const { container, getByTestId } = shown(sightOf());
    act(() => receive(changed("failed", "camera_dark")));
    expect(getByTestId("camera-trouble").textContent).toMatch(/^Está escuro demais/);
    act(() => receive(sightOf(hand())));
    expect(container.textContent).toContain("97%");
  });

  test("is nothing where there is no picture", () => {
    const { container } = shown(sightOf(hand()));
    act(() => receive(changed("failed", "camera_missing")));
    expect(container.textContent).toBe("");
  });
});
