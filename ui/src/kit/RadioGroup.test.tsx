import { cleanup, fireEvent, render } from "@testing-library/preact";
import { Check } from "lucide-preact";
import { afterEach, describe, expect, test, vi } from "vitest";
import { RadioGroup } from "./RadioGroup";
import { Tabs } from "./Tabs";
import { passesAxe } from "./testing/control";

afterEach(cleanup);

const OPTIONS = [
  ["apart", "Lado a lado"],
  ["together", "No mesmo chão", { icon: Check, "data-name": "one" }],
  ["plot", "Gráfico"],
] as const;

describe("a choice of a few", () => {
  test("shows which is on, and tells which was pressed", async () => {
    const onChange = vi.fn();
    const { container, getByRole } = render(
      <RadioGroup label="Ver" value="apart" options={OPTIONS} onChange={onChange} />,
    );
    expect(getByRole("button", { pressed: true }).dataset.value).toBe("apart");
    const other = getByRole("button", { name: "No mesmo chão" });
    expect(other.dataset.name).toBe("one");
    fireEvent.click(other);
    expect(onChange).toHaveBeenCalledWith("together");
    expect(getByRole("group", { name: "Ver" })).toBeTruthy();
    await passesAxe(container);
  });

  test("can have its name in sight, and values that are no text", () => {
    const onChange = vi.fn();
    const { getByRole } = render(
      <RadioGroup
        label="Peso"
        legendClass="switch__word"
        value={true}
        options={[
          [false, "fixo"],
          [true, "solto"],
        ]}
        onChange={onChange}
      />,
    );
    expect(getByRole("group", { name: "Peso" }).querySelector("legend")).toBeTruthy();
    fireEvent.click(getByRole("button", { name: "fixo" }));
    expect(onChange).toHaveBeenCalledWith(false);
  });
});

describe("tabs", () => {
  const draw = (onChange: (value: string) => void) =>
    render(<Tabs label="Ver" value="apart" options={OPTIONS} onChange={onChange} />);

  test("are one stop of the Tab key, at the one that is shown", async () => {
    const { container, getAllByRole } = draw(() => {});
    expect(getAllByRole("tab").map((tab) => tab.tabIndex)).toEqual([0, -1, -1]);
    await passesAxe(container);
  });

  test("change by press, and by the arrows round and round", () => {
    const onChange = vi.fn();
    const { getAllByRole, getByRole } = draw(onChange);
    fireEvent.click(getAllByRole("tab")[1] as Element);
    fireEvent.keyDown(getByRole("tablist"), { key: "ArrowRight" });
    fireEvent.keyDown(getByRole("tablist"), { key: "ArrowLeft" });
    fireEvent.keyDown(getByRole("tablist"), { key: "ArrowDown" });
    expect(onChange.mock.calls).toEqual([["together"], ["together"], ["plot"]]);
    expect(document.activeElement).toBe(getAllByRole("tab")[2]);
  });
});
