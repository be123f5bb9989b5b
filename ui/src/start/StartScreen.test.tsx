import { cleanup, render, screen } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { classesApi } from "../api/classes";
import { api } from "../api/client";
import type { TeacherSession } from "../api/model";
import { teacherSession } from "../shell/teacher/teacher_session";
import { StartScreen } from "./StartScreen";

beforeEach(() => {
  teacherSession.value = null;
  vi.spyOn(api, "groups").mockResolvedValue([]);
  vi.spyOn(classesApi, "classrooms").mockResolvedValue([]);
});

afterEach(() => {
  cleanup();
  vi.restoreAllMocks();
});

test("nothing of the first screen moves: it appears with the links of a PC without PIN", async () => {
  let answer: (session: TeacherSession) => void = () => {};
  const session = new Promise<TeacherSession>((resolve) => {
    answer = resolve;
  });
  vi.spyOn(classesApi, "teacherSession").mockReturnValue(session);
  render(<StartScreen />);
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(screen.queryByTestId("group-name")).toBeNull();
  answer({ has_pin: false, is_open: false });
  await screen.findByTestId("group-name");
  expect(screen.queryByTestId("prepare")).toBeTruthy();
});

test("groups are shown although the teacher's session could not be read", async () => {
  vi.spyOn(classesApi, "teacherSession").mockRejectedValue(new Error("gone"));
  render(<StartScreen />);
  expect(await screen.findByTestId("group-name")).toBeTruthy();
});
