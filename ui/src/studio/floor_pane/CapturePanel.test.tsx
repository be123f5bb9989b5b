import { act, cleanup, fireEvent, render, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { changed, hand, numberOf, sightOf } from "../../camera/testing/camera_events";
import { setLanguage } from "../../i18n";
import { passesAxe } from "../../kit/testing/control";

const cameraApi = { status: vi.fn(), choose: vi.fn(), warmUp: vi.fn() };
vi.mock("../../api/camera", () => ({ cameraApi, previewAddress: () => "" }));

const signsApi = { use: vi.fn() };
vi.mock("../../api/signs", () => ({ signsApi }));

const { CapturePanel } = await import("./CapturePanel");
const { SignDrawing } = await import("../../camera/SignDrawing");
const { chooseSigns, LETTERS } = await import("../../camera/signs");
const { receive } = await import("../../camera/sight");

const capture = { block: "b", timeoutS: 10, leftS: 7.2, what: "sign" } as const;
const onAnswer = vi.fn();

/** Loads the sign list of a class that taught these signs. */
const teachSigns = (...names: string[]) => {
  const taught = names.map((name) => ({
    name,
    is_letter: false,
    n_samples: 10,
    n_movements: 0,
    landmarks: HAND,
  }));
  const letters = LETTERS.map((name) => ({
    ...{ name, is_letter: true, n_samples: 0, n_movements: 0, landmarks: null },
  }));
  signsApi.use.mockResolvedValue([...letters, ...taught]);
  return act(() => chooseSigns("c"));
};
const HAND = Array.from({ length: 21 }, (_, n) => [n / 20, (n % 5) / 5, 0]);

beforeEach(async () => {
  vi.clearAllMocks();
  cameraApi.status.mockResolvedValue({ state: "on", source: "0", problem: null });
  cameraApi.choose.mockResolvedValue({ state: "opening", source: "1", problem: null });
  await teachSigns();
  receive(changed("on"));
});
afterEach(cleanup);

const draw = (expected: readonly string[] = ["B", "L"]) =>
  render(<CapturePanel capture={capture} expected={expected} onAnswer={onAnswer} />);

describe("a program that waits for a sign", () => {
  test("can be answered by hand at once, whatever the camera does", () => {
    const { getAllByTestId } = draw();
    const letters = getAllByTestId("capture-letter");
    expect(letters).toHaveLength(22);
    fireEvent.click(letters[1] as HTMLElement);
    fireEvent.click(letters[21] as HTMLElement);
    expect(onAnswer.mock.calls).toEqual([["B"], [""]]);
  });

  test("can be answered with the letter's key, unless something is being written", () => {
    const { container } = draw();
    fireEvent.keyDown(document.body, { key: "l" });
    fireEvent.keyDown(document.body, { key: "h" });
    fireEvent.keyDown(document.body, { key: "a", ctrlKey: true });
    const field = container.appendChild(document.createElement("input"));
    fireEvent.keyDown(field, { key: "b" });
    expect(onAnswer.mock.calls).toEqual([["L"]]);
  });

  test("shows the signs that it knows what to do with, and marks the one that is seen", async () => {
    const { container, findAllByTestId } = draw();
    const signs = await findAllByTestId("expected-sign");
    expect(signs.map((one) => one.dataset.sign)).toEqual(["B", "L"]);
    act(() => receive(sightOf(hand({ best: "L" }))));
    expect(signs.map((one) => one.dataset.seen)).toEqual(["false", "true"]);
    await passesAxe(container);
  });

  test("says what is wrong with the camera in place of its picture", async () => {
    const { container, findByTestId } = draw();
    await findByTestId("reading");
    act(() => receive(changed("failed", "camera_missing")));
    expect((await findByTestId("camera-trouble")).dataset.code).toBe("camera_missing");
    expect(container.querySelector("h2")?.textContent).toBe("Qual letra ou sinal vocês fizeram?");
    await passesAxe(container);
  });

  test("looks through another camera when it is chosen", async () => {
    const { findByTestId } = draw();
    const choice = (await findByTestId("camera-choice")) as HTMLSelectElement;
    expect([...choice.options].map((one) => one.text)).toEqual([
      "Câmera 1",
      "Câmera 2",
      "Câmera 3",
    ]);
    fireEvent.change(choice, { target: { value: "1" } });
    await waitFor(() => expect(choice.value).toBe("1"));
    expect(cameraApi.choose).toHaveBeenCalledWith("1");
  });

  test("can be answered with a sign that the class taught, and with one that only the program knows", async () => {
    await teachSigns("vai", "7");
    const { container, getAllByTestId } = draw(["B", "pare"]);
    const kinds = getAllByTestId("capture-kind");
    expect(kinds[0]?.getAttribute("aria-selected")).toBe("true");
    fireEvent.click(kinds[1] as HTMLElement);
    const answers = getAllByTestId("capture-letter");
    expect(answers.map((one) => one.dataset.letter)).toEqual(["vai", "7", "pare", ""]);
    fireEvent.click(answers[0] as HTMLElement);
    fireEvent.keyDown(document.body, { key: "7" });
    expect(onAnswer.mock.calls).toEqual([["vai"], ["7"]]);
    await passesAxe(container);
  });

  test("begins with the signs of the class where the program expects no letter", async () => {
    await teachSigns("vai");
    const { getAllByTestId, findAllByTestId } = draw(["vai"]);
    expect(getAllByTestId("capture-letter").map((one) => one.dataset.letter)).toEqual(["vai", ""]);
    const [expected] = await findAllByTestId("expected-sign");
    expect(expected?.querySelectorAll("path").length).toBeGreaterThan(10);
    fireEvent.click(expected as HTMLElement);
    expect(onAnswer).toHaveBeenCalledWith("vai");
  });

  test("has a drawing for what the class taught, and its name where there is none", async () => {
    await teachSigns("vai");
    const { findAllByTestId } = draw(["vai", "bom dia"]);
    const [taught, unknown] = await findAllByTestId("expected-sign");
    expect(taught?.querySelector("svg path")).toBeTruthy();
    expect(unknown?.querySelector("svg")).toBeNull();
    expect(unknown?.textContent).toBe("bom dia");
    const { container } = render(<SignDrawing sign="bom dia" />);
    expect([...container.querySelectorAll("text")].map((one) => one.textContent)).toEqual([
      ...["bom", "dia"],
    ]);
  });

  test("finds one of many signs by its name, and answers it with Enter", async () => {
    await teachSigns(...Array.from({ length: 58 }, (_, n) => `sinal ${n}`), "coração", "cor");
    const { getAllByTestId, getByTestId } = draw(["cor"]);
    const field = getByTestId("capture-find");
    fireEvent.keyDown(field, { key: "Enter" });
    fireEvent.input(field, { target: { value: "CORAÇ" } });
    expect(getAllByTestId("capture-letter").map((one) => one.dataset.letter)).toEqual([
      ...["", "coração"],
    ]);
    fireEvent.keyDown(field, { key: "Enter" });
    expect(onAnswer.mock.calls).toEqual([["coração"]]);
  });

  test("turns its drawings to the hand that is seen, or chosen", async () => {
    const { findByTestId, findAllByTestId } = draw();
    const path = async () => {
      const [first] = await findAllByTestId("expected-sign");
      return first?.querySelector("path")?.getAttribute("d");
    };
    const right = await path();
    act(() => {
      for (let n = 0; n < 4; n++) receive(sightOf(hand({ handedness: "left" })));
    });
    expect(await path()).not.toBe(right);
    fireEvent.click(await findByTestId("drawn-hand"));
    expect(await path()).toBe(right);
  });

  test("says what is wrong with the camera in the language of the page", async () => {
    const { findByTestId } = draw();
    await findByTestId("reading");
    act(() => receive(changed("failed", "camera_missing")));
    const trouble = await findByTestId("camera-trouble");
    expect(trouble.textContent).toContain("A câmera 1 não foi encontrada.");
    await act(() => setLanguage("en"));
    expect(trouble.textContent).toContain("Camera 1");
    await act(() => setLanguage("pt-BR"));
  });
});

describe("a program that waits for a number", () => {
  const drawNumber = () =>
    render(
      <CapturePanel
        capture={{ ...capture, what: "number" }}
        expected={["B"]}
        onAnswer={onAnswer}
      />,
    );

  test("is answered with a button for each number that two hands can show, or with a digit", async () => {
    const { container, getAllByTestId, queryAllByTestId, findByTestId } = drawNumber();
    await findByTestId("reading");
    const answers = getAllByTestId("capture-letter");
    const digits = Array.from({ length: 11 }, (_, number) => String(number));
    expect(answers.map((one) => one.dataset.letter)).toEqual([...digits, ""]);
    expect(queryAllByTestId("expected-sign")).toHaveLength(0);
    fireEvent.click(answers[10] as HTMLElement);
    fireEvent.click(answers[11] as HTMLElement);
    fireEvent.keyDown(document.body, { key: "7" });
    fireEvent.keyDown(document.body, { key: "b" });
    expect(onAnswer.mock.calls).toEqual([["10"], [""], ["7"]]);
    expect(container.querySelector("h2")?.textContent).toBe("Mostrem um número com os dedos");
    await passesAxe(container);
  });

  test("shows the doubt of the camera between two numbers", async () => {
    const { findByTestId } = drawNumber();
    const reading = await findByTestId("reading");
    act(() => receive(numberOf({ sure: false, confidence: 0.6 })));
    expect(reading.dataset.kind).toBe("unsure");
    expect(reading.textContent).toContain("3 ou 4?");
  });
});
