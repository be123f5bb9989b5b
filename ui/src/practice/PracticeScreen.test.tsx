import { act, cleanup, fireEvent, render, screen } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { changed, hand, sightOf } from "../camera/testing/camera_events";
import { passesAxe } from "../kit/testing/control";

const cameraApi = { status: vi.fn() };
vi.mock("../api/camera", () => ({ cameraApi, previewAddress: () => "" }));

const { PracticeScreen } = await import("./PracticeScreen");
const { receive } = await import("../camera/sight");

beforeEach(() => {
  cameraApi.status.mockReturnValue(new Promise(() => {}));
  receive(changed("on"));
});
afterEach(cleanup);

const chosen = () =>
  screen
    .getAllByTestId("practice-sign")
    .filter((one) => one.getAttribute("aria-pressed") === "true")
    .map((one) => one.dataset.letter);
const text = () => screen.getByTestId<HTMLInputElement>("practice-text").value;

describe("practising signs", () => {
  test("a letter to imitate is chosen with its button or its key, for either hand", async () => {
    const { container } = render(<PracticeScreen />);
    expect(chosen()).toEqual(["A"]);
    fireEvent.click(screen.getAllByTestId("practice-sign")[1] as HTMLElement);
    expect(chosen()).toEqual(["B"]);
    const right = container.querySelector(".imitation path")?.getAttribute("d");
    fireEvent.click(screen.getAllByTestId("practice-hand")[0] as HTMLElement);
    expect(container.querySelector(".imitation path")?.getAttribute("d")).not.toBe(right);
    fireEvent.keyDown(document.body, { key: "l" });
    expect(chosen()).toEqual(["L"]);
    await passesAxe(container);
  });

  test("says when the letter is imitated, and which other letter is seen instead", () => {
    render(<PracticeScreen />);
    act(() => receive(sightOf(hand({ best: "B" }))));
    expect(screen.queryByText("É isso! Letra A.")).toBeNull();
    expect(screen.getByText("A câmera vê: Letra B. Ainda não é: Letra A.")).toBeTruthy();
    act(() => receive(sightOf(hand({ best: "A" }))));
    expect(screen.getByText("É isso! Letra A.")).toBeTruthy();
  });

  test("the text is written with keys and buttons too", () => {
    render(<PracticeScreen />);
    fireEvent.input(screen.getByTestId("practice-text"), { target: { value: "OI" } });
    fireEvent.click(screen.getByTestId("practice-space"));
    fireEvent.click(screen.getByTestId("practice-back"));
    fireEvent.click(screen.getByTestId("practice-back"));
    expect(text()).toBe("O");
    fireEvent.click(screen.getByTestId("practice-clear"));
    expect(text()).toBe("");
    fireEvent.click(screen.getByTestId("practice-clear"));
    expect(text()).toBe("O");
  });

  test("is a game of words too, by signs or keys, with a hand as a hint", async () => {
    const { container } = render(<PracticeScreen />);
    fireEvent.click(screen.getByText("Jogo de palavras"));
    const target = () => screen.getByTestId("game-word").getAttribute("aria-label") ?? "";
    const spelled = () => container.querySelectorAll('[data-state="spelled"]').length;
    fireEvent.click(screen.getByTestId("game-hint"));
    expect(container.querySelector(".game .sign-drawing")).toBeTruthy();
    fireEvent.keyDown(document.body, { key: target()[0]?.toLowerCase() });
    expect(spelled()).toBe(1);
    expect(container.querySelector(".game .sign-drawing")).toBeNull();
    await passesAxe(container);
    for (let n = 0; n < 5; n++) fireEvent.click(screen.getByTestId("game-skip"));
    expect(screen.getByTestId("game-outcome").textContent).toContain("Para praticar mais: ");
    fireEvent.click(screen.getByTestId("game-again"));
    expect(target()).not.toBe("");
  });

  test("goes on without a camera: drawings, letters and text stay", async () => {
    const { container } = render(<PracticeScreen />);
    act(() => receive(changed("failed", "camera_missing")));
    expect(screen.getByTestId("camera-trouble")).toBeTruthy();
    expect(screen.queryByTestId("reading")).toBeNull();
    expect(screen.getAllByTestId("practice-sign")).toHaveLength(21);
    await passesAxe(container);
  });
});
