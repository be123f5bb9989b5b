import { act, cleanup, fireEvent, render, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { changed, hand, seen } from "../../camera/testing/seen";
import { passesAxe } from "../../kit/testing/control";
import { TEST } from "../../shell/testids";

const cameraApi = { status: vi.fn(), choose: vi.fn(), wake: vi.fn() };
vi.mock("../../api/camera", () => ({ cameraApi, previewAddress: () => "" }));

const { CapturePanel } = await import("./CapturePanel");
const { receive } = await import("../../camera/sight");

const capture = { block: "b", timeoutS: 10, leftS: 7.2 };
const onAnswer = vi.fn();

beforeEach(() => {
  vi.clearAllMocks();
  cameraApi.status.mockResolvedValue({ state: "on", source: "0", problem: null });
  cameraApi.choose.mockResolvedValue({ state: "opening", source: "1", problem: null });
  receive(changed("on"));
});
afterEach(cleanup);

const draw = () =>
  render(<CapturePanel capture={capture} expected={["B", "L"]} onAnswer={onAnswer} />);

describe("a program that waits for a sign", () => {
  test("can be answered by hand at once, whatever the camera does", () => {
    const { getAllByTestId } = draw();
    const letters = getAllByTestId(TEST.captureLetter);
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
    const signs = await findAllByTestId(TEST.expectedSign);
    expect(signs.map((one) => one.dataset.sign)).toEqual(["B", "L"]);
    act(() => receive(seen(hand({ best: "L" }))));
    expect(signs.map((one) => one.dataset.seen)).toEqual(["false", "true"]);
    await passesAxe(container);
  });

  test("says what is wrong with the camera in place of its picture", async () => {
    const { container, findByTestId } = draw();
    await findByTestId(TEST.reading);
    act(() => receive(changed("failed", "camera_missing")));
    expect((await findByTestId(TEST.cameraTrouble)).dataset.code).toBe("camera_missing");
    expect(container.querySelector("h2")?.textContent).toBe("Que sinal vocês fizeram?");
    await passesAxe(container);
  });

  test("looks through another camera when it is chosen", async () => {
    const { findByTestId } = draw();
    const choice = (await findByTestId(TEST.cameraChoice)) as HTMLSelectElement;
    expect([...choice.options].map((one) => one.text)).toEqual([
      "Câmera 1",
      "Câmera 2",
      "Câmera 3",
    ]);
    fireEvent.change(choice, { target: { value: "1" } });
    await waitFor(() => expect(choice.value).toBe("1"));
    expect(cameraApi.choose).toHaveBeenCalledWith("1");
  });
});
