import { cleanup, act as drawn, render } from "@testing-library/preact";
import { afterEach, describe, expect, test, vi } from "vitest";
import { useInstance } from "../instance";
import { useAction } from "./action";
import { Refused } from "./problem";

afterEach(cleanup);

describe("a form's request", () => {
  let form: ReturnType<typeof useAction>;
  const through = vi.fn((work: () => Promise<unknown>) => work());
  function Form() {
    form = useAction(through);
    return null;
  }

  test("that is done leaves no fault", async () => {
    render(<Form />);
    let done: boolean | null = null;
    await drawn(async () => {
      done = await form.act(async () => {});
    });
    expect([done, form.busy, form.fault]).toEqual([true, false, null]);
    expect(through).toHaveBeenCalled();
  });

  test("that fails tells why, until it is cleared", async () => {
    render(<Form />);
    const failure = new Refused("Sem espaço.", "Apaguem algo.");
    await drawn(async () => {
      await form.act(() => Promise.reject(failure));
    });
    expect(form.fault).toEqual({ message: "Sem espaço.", remedy: "Apaguem algo." });
    await drawn(() => form.clear());
    expect(form.fault).toBeNull();
    await drawn(() => form.refuse("Falta o nome."));
    expect(form.fault).toEqual({ message: "Falta o nome.", remedy: "" });
  });
});

test("an instance is made once and disposed at the end", () => {
  const dispose = vi.fn();
  const make = vi.fn(() => ({ dispose }));
  function Owner() {
    useInstance(make);
    return null;
  }
  const { rerender, unmount } = render(<Owner />);
  rerender(<Owner />);
  expect(make).toHaveBeenCalledTimes(1);
  expect(dispose).not.toHaveBeenCalled();
  unmount();
  expect(dispose).toHaveBeenCalledTimes(1);
});
