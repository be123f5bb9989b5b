import { act, cleanup, fireEvent, render, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { reportTo } from "../report";
import { passesAxe } from "../testing/control";
import { Loaded } from "./Loaded";
import { type Ask, UNCHANGED } from "./load_state";
import { type LoadedOptions, useLoaded } from "./useLoaded";

interface Request {
  signal: AbortSignal;
  respond(names: readonly string[]): Promise<void>;
  fail(error?: Error): Promise<void>;
}

let requests: Request[];
const shown = vi.fn();
const FULL = new Error("full");

const ask: Ask<readonly string[]> = (signal) => {
  let answer: (names: readonly string[]) => void = () => {};
  let fail: (error: Error) => void = () => {};
  const asked = new Promise<readonly string[]>((resolve, reject) => {
    answer = resolve;
    fail = reject;
  });
  const drawn = (end: () => void) =>
    act(async () => {
      end();
      await asked.catch(() => {});
    });
  requests.push({
    signal,
    respond: (names) => drawn(() => answer(names)),
    fail: (error = FULL) => drawn(() => fail(error)),
  });
  return asked;
};

const request = (n: number) => requests[n] as Request;

interface ListProps {
  about?: string | readonly string[];
  options?: LoadedOptions<readonly string[]>;
}

function List({ about = "a", options = {} }: ListProps) {
  const list = useLoaded(about, ask, options);
  return (
    <>
      <Loaded of={list} as="screen" loading="Abrindo" empty={<p>Nada ainda</p>}>
        {(names, { busy }) => <main aria-busy={busy}>{names.join(" ")}</main>}
      </Loaded>
      <button type="button" onClick={() => void list.reload()}>
        De novo
      </button>
      <button type="button" onClick={() => list.set(["C"])}>
        Pôr
      </button>
    </>
  );
}

const screen = () => document.querySelector("main") as HTMLElement;
const press = (name: string) => {
  const buttons = [...document.querySelectorAll("button")];
  fireEvent.click(buttons.find((one) => one.textContent === name) as Element);
};

beforeEach(() => {
  requests = [];
  shown.mockReset();
  reportTo(shown);
});
afterEach(cleanup);

describe("what is loaded", () => {
  test("is announced, and then shown", async () => {
    const { container } = render(<List />);
    expect(screen().textContent).toBe("Abrindo");
    expect(screen().ariaBusy).toBe("true");
    await passesAxe(container);
    await request(0).respond(["A", "B"]);
    expect(screen().textContent).toBe("A B");
  });

  test("with nothing in it says so", async () => {
    const { getByText } = render(<List />);
    await request(0).respond([]);
    expect(getByText("Nada ainda")).toBeTruthy();
  });

  test("that failed says so, is reported, and can be tried again", async () => {
    const { container, getByTestId } = render(<List />);
    await request(0).fail();
    expect(screen().ariaBusy).toBeNull();
    expect(getByTestId("not-loaded").textContent).not.toBe("");
    expect(shown).toHaveBeenCalledWith(FULL);
    await passesAxe(container);
    fireEvent.click(getByTestId("try-again"));
    await waitFor(() => expect(getByTestId("try-again").ariaBusy).toBe("true"));
    await request(1).respond(["A"]);
    expect(screen().textContent).toBe("A");
  });

  test("and failed can be told to somebody else", async () => {
    const onFailed = vi.fn();
    render(<List options={{ onFailed }} />);
    await request(0).fail();
    expect(onFailed).toHaveBeenCalledWith(FULL);
    expect(shown).not.toHaveBeenCalled();
  });

  test("stays while it is asked for again, and when that fails", async () => {
    render(<List />);
    await request(0).respond(["A"]);
    press("De novo");
    await waitFor(() => expect(screen().ariaBusy).toBe("true"));
    expect(screen().textContent).toBe("A");
    await request(1).fail();
    expect(screen().textContent).toBe("A");
    expect(screen().ariaBusy).toBe("false");
    expect(shown).toHaveBeenCalledWith(FULL);
  });

  test("is the answer to the latest request, whichever comes last", async () => {
    const { rerender } = render(<List />);
    rerender(<List about="b" />);
    expect(request(0).signal.aborted).toBe(true);
    await request(1).respond(["B"]);
    await request(0).respond(["A"]);
    expect(screen().textContent).toBe("B");
  });

  test("can be set, and an answer on its way no longer counts", async () => {
    render(<List />);
    await request(0).respond(["A"]);
    press("De novo");
    press("Pôr");
    await request(1).respond(["B"]);
    expect(screen().textContent).toBe("C");
    expect(screen().ariaBusy).toBe("false");
  });

  test("is not waited for by who has left", async () => {
    const release = vi.fn();
    const { unmount } = render(<List options={{ release }} />);
    unmount();
    expect(request(0).signal.aborted).toBe(true);
    await request(0).respond(["A"]);
    expect(release).toHaveBeenCalledWith(["A"]);
  });

  test("and fails after one has left is nobody's business", async () => {
    const { unmount } = render(<List />);
    unmount();
    await request(0).fail();
    expect(shown).not.toHaveBeenCalled();
  });

  test("is freed when another takes its place, and when one leaves", async () => {
    const release = vi.fn();
    const { unmount } = render(<List options={{ release }} />);
    await request(0).respond(["A"]);
    press("De novo");
    await request(1).respond(["B"]);
    expect(release.mock.calls).toEqual([[["A"]]]);
    unmount();
    expect(release.mock.calls).toEqual([[["A"]], [["B"]]]);
  });

  test("of several parts is asked for when one of them changes, and not when drawn again", async () => {
    const { rerender } = render(<List about={["a", "b"]} />);
    rerender(<List about={["a", "b"]} />);
    expect(requests).toHaveLength(1);
    rerender(<List about={["a", "c"]} />);
    expect(requests).toHaveLength(2);
  });

  test("waits until its key rests, once there is something to show", async () => {
    const options = { debounceMs: 60_000 };
    const { rerender, unmount } = render(<List options={options} />);
    expect(requests).toHaveLength(1);
    await request(0).respond(["A"]);
    vi.useFakeTimers();
    rerender(<List about="b" options={options} />);
    vi.advanceTimersByTime(59_000);
    rerender(<List about="c" options={options} />);
    vi.advanceTimersByTime(59_000);
    expect(requests).toHaveLength(1);
    vi.advanceTimersByTime(1000);
    expect(requests).toHaveLength(2);
    unmount();
    vi.useRealTimers();
  });

  test("is asked for when the window is come back to, where that is wished", async () => {
    const onFocus = vi.fn(async () => ["B"]);
    render(<List options={{ onFocus }} />);
    fireEvent.focus(window);
    expect(onFocus).not.toHaveBeenCalled();
    await request(0).respond(["A"]);
    fireEvent.focus(window);
    await waitFor(() => expect(screen().textContent).toBe("B"));
  });

  test("stays as it is when coming back brings no news", async () => {
    render(<List options={{ onFocus: async () => UNCHANGED }} />);
    await request(0).respond(["A"]);
    fireEvent.focus(window);
    await waitFor(() => expect(screen().ariaBusy).toBe("false"));
    expect(screen().textContent).toBe("A");
  });
});
