import { cleanup, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import type { Sticker } from "../api/model";
import { passesAxe } from "../kit/testing/control";
import { Place } from "./Place";
import { dayOf } from "./words";

const startMission = vi.hoisted(() => vi.fn(async () => {}));
vi.mock("../shell/begin_activity", () => ({ beginActivity: startMission }));

const square: Sticker = {
  name: "square",
  kind: "mission",
  path: "shapes",
  title: "Um quadrado de 1 m",
  win: null,
  n_done: 0,
  n_needed: 1,
};
const WIN = { won_at: "2020-11-12T13:00:00Z", run_id: "r1" };

afterEach(cleanup);

test("an empty place says what to do and opens its mission", async () => {
  const { container } = render(<Place sticker={square} group="g" />);
  const place = screen.getByRole("button", {
    name: /Um quadrado de 1 m.*Lugar vazio\.\s*Façam um quadrado/,
  });
  place.click();
  expect(startMission).toHaveBeenCalledWith("g", "square");
  await passesAxe(container);
});

test("a sticker says when it was won and leads to the run that won it", () => {
  render(<Place sticker={{ ...square, win: WIN }} group="g" />);
  const link = screen.getByRole("link", { name: /Colada em 12 de nov\. de 2020/ });
  expect(link.getAttribute("href")).toBe("#/run/r1");
});

test("a place for character is no button, and counts what is done", () => {
  const careful: Sticker = {
    ...square,
    name: "careful",
    kind: "character",
    title: "",
    n_done: 7,
    n_needed: 10,
  };
  const { container } = render(<Place sticker={careful} group="g" />);
  expect(screen.queryByRole("button")).toBeNull();
  expect(container.textContent).toContain("Dez sem bater");
  expect(container.textContent).toContain("7 de 10");
});

test("an activity of a teacher has its title and a general sentence", () => {
  const own: Sticker = { ...square, name: "k", kind: "own", path: null, title: "Até a porta" };
  render(<Place sticker={own} group="g" />);
  expect(screen.getByRole("button", { name: /Até a porta.*feita na escola/ })).toBeTruthy();
});

test("the day has its year unless it is this one", () => {
  const now = new Date("2026-11-26T12:00:00Z");
  expect(dayOf("2026-11-12T13:00:00Z", "pt-BR", now)).toBe("12 de nov.");
  expect(dayOf("2025-11-12T13:00:00Z", "pt-BR", now)).toBe("12 de nov. de 2025");
});
