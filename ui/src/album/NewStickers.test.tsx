import { cleanup, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import type { Album, Sticker } from "../api/model";
import { NewStickers } from "./NewStickers";

const requests = vi.hoisted(() => ({ of: vi.fn() }));
vi.mock("../api/album", () => ({ albumApi: requests }));

const sticker = (name: string, title: string, run: string | null): Sticker => ({
  name,
  kind: title ? "mission" : "character",
  path: title ? "moves" : null,
  title,
  win: run === null ? null : { won_at: "2026-11-12T13:00:00Z", run_id: run },
  n_done: 0,
  n_needed: 1,
});
const answers = (...stickers: Sticker[]) =>
  requests.of.mockResolvedValue({ enabled: true, stickers } satisfies Album);

afterEach(cleanup);

test("only what this run has won is told, in one link to the album", async () => {
  answers(
    sticker("to_the_bakery", "Até a padaria", "now"),
    sticker("stairs", "A escada", "before"),
    sticker("square", "Um quadrado de 1 m", null),
    sticker("repair", "", "now"),
  );
  render(<NewStickers group="g" run="now" />);
  const link = await screen.findByRole("link", {
    name: "Figurinhas novas: Até a padaria e Consertamos!",
  });
  expect(link.getAttribute("href")).toBe("#/album/g");
  expect(link.querySelectorAll(".sticker")).toHaveLength(2);
});

test("a mission that was passed before wins nothing new", async () => {
  answers(sticker("stairs", "A escada", "before"));
  const { container } = render(<NewStickers group="g" run="now" />);
  expect(container.querySelector(".new-stickers")).toBeTruthy();
  await vi.waitFor(() => expect(container.querySelector(".new-stickers")).toBeNull());
});

test("an album that does not load leaves the success alone", async () => {
  requests.of.mockRejectedValue(new Error("gone"));
  const { container } = render(<NewStickers group="g" run="now" />);
  await vi.waitFor(() => expect(container.innerHTML).toBe(""));
});
