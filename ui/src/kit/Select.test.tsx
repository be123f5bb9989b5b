import { fireEvent, render, waitFor } from "@testing-library/preact";
import { describe, expect, test, vi } from "vitest";
import { reportTo } from "./report";
import { Select } from "./Select";
import { behavesAsControl } from "./testing/control";

const SPEEDS = [
  [0.5, "metade"],
  [1, "normal"],
  [null, "a mais alta"],
] as const;

const select = () => document.querySelector("select") as HTMLSelectElement;
const choose = (value: string) => fireEvent.change(select(), { target: { value } });

describe("a select", () => {
  behavesAsControl(({ elementRef, ...props }) => (
    <Select
      {...props}
      elementRef={elementRef as { current: HTMLSelectElement | null }}
      label="Velocidade"
      value={1}
      options={SPEEDS}
      onChange={() => {}}
    />
  ));

  test("gives the value that was chosen, not its text", () => {
    const onChange = vi.fn();
    render(<Select label="Velocidade" value={1} options={SPEEDS} onChange={onChange} />);
    expect(select().value).toBe("1");
    choose("0.5");
    choose("");
    expect(onChange.mock.calls).toEqual([[0.5], [null]]);
  });

  test("shows its value, whatever was chosen", () => {
    render(<Select label="Velocidade" value={1} options={SPEEDS} onChange={() => {}} />);
    choose("0.5");
    expect(select().value).toBe("1");
  });

  test("has options under headings, each with attributes of its own", () => {
    const { getByRole } = render(
      <Select
        label="Versão"
        value="b"
        groups={[
          ["hoje", [["a", "3", { lang: "es" }]]],
          ["ontem", [["b", "2"]]],
        ]}
        onChange={() => {}}
      />,
    );
    expect(getByRole("option", { name: "3" }).lang).toBe("es");
    expect(select().selectedOptions[0]?.parentElement?.getAttribute("label")).toBe("ontem");
  });

  test("reports what failed", async () => {
    const shown = vi.fn();
    reportTo(shown);
    const onChange = () => Promise.reject(new Error("full"));
    render(<Select label="Velocidade" value={1} options={SPEEDS} onChange={onChange} />);
    choose("0.5");
    await waitFor(() => expect(shown).toHaveBeenCalledWith(new Error("full")));
  });
});
