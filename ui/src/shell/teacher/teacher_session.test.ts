import { waitFor } from "@testing-library/preact";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { classesApi } from "../../api/classes";
import { ApiError } from "../../api/errors";
import type { TeacherSession } from "../../api/model";
import * as firstAnswers from "../first_answers";
import {
  asTeacher,
  cancelWaiting,
  loadTeacherSession,
  signOut,
  teacherSession,
} from "./teacher_session";

const OPEN = { has_pin: true, is_open: true };
const shut = () => new ApiError(403, { code: "teacher_only" });

beforeEach(() => {
  teacherSession.value = OPEN;
});

describe("what only the teacher may do", () => {
  test("is done while the teacher is signed in", async () => {
    expect(await asTeacher(async () => 7)).toBe(7);
  });

  test("waits for the PIN when the session has ended, and is done then", async () => {
    const work = vi.fn().mockRejectedValueOnce(shut()).mockResolvedValueOnce("done");
    const done = asTeacher<string>(work);
    await waitFor(() => expect(teacherSession.value?.is_open).toBe(false));
    expect(work).toHaveBeenCalledTimes(1);
    teacherSession.value = OPEN;
    expect(await done).toBe("done");
  });

  test("is not done later when the teacher has gone elsewhere", async () => {
    const work = vi.fn().mockRejectedValue(shut());
    void asTeacher(work);
    await waitFor(() => expect(teacherSession.value?.is_open).toBe(false));
    cancelWaiting();
    teacherSession.value = OPEN;
    await Promise.resolve();
    expect(work).toHaveBeenCalledTimes(1);
  });

  test("is tried again without the PIN if the teacher signed in while the request was under way", async () => {
    teacherSession.value = { has_pin: true, is_open: false };
    let refuse: (error: unknown) => void = () => {};
    const refused = new Promise<string>((_, reject) => {
      refuse = reject;
    });
    const work = vi.fn().mockReturnValueOnce(refused).mockResolvedValueOnce("done");
    const done = asTeacher<string>(work);
    teacherSession.value = OPEN;
    refuse(shut());
    expect(await done).toBe("done");
    expect(teacherSession.value).toEqual(OPEN);
  });

  test("is finished before the teacher is signed out: the server would refuse it", async () => {
    const leave = vi
      .spyOn(classesApi, "leave")
      .mockResolvedValue({ has_pin: true, is_open: false });
    let respond: (value: string) => void = () => {};
    const saved = asTeacher(() => new Promise<string>((resolve) => (respond = resolve)));
    const left = signOut();
    await Promise.resolve();
    expect(leave).not.toHaveBeenCalled();
    respond("saved");
    expect(await saved).toBe("saved");
    await left;
    expect(leave).toHaveBeenCalledTimes(1);
    expect(teacherSession.value?.is_open).toBe(false);
  });

  test("says what else went wrong", async () => {
    const conflict = new ApiError(409, { code: "group_exists" });
    await expect(asTeacher(() => Promise.reject(conflict))).rejects.toBe(conflict);
    expect(teacherSession.value).toEqual(OPEN);
  });
});

describe("the state of the session that the page asks for", () => {
  const shutState = { has_pin: true, is_open: false };

  test("is what the server says", async () => {
    vi.spyOn(classesApi, "teacherSession").mockResolvedValue(shutState);
    expect(await loadTeacherSession()).toEqual(shutState);
    expect(teacherSession.value).toEqual(shutState);
  });

  test("does not end the session of a teacher who signed in before the response came", async () => {
    let answer: (session: TeacherSession) => void = () => {};
    vi.spyOn(classesApi, "teacherSession").mockReturnValue(
      new Promise((resolve) => {
        answer = resolve;
      }),
    );
    teacherSession.value = shutState;
    const loaded = loadTeacherSession();
    teacherSession.value = { ...OPEN };
    answer(shutState);
    expect(await loaded).toEqual(OPEN);
    expect(teacherSession.value).toEqual(OPEN);
  });

  test("is asked anew if the teacher signed in before, because the early response is older", async () => {
    const early = vi.spyOn(firstAnswers, "firstTeacherSession");
    const now = vi.spyOn(classesApi, "teacherSession").mockClear().mockResolvedValue(OPEN);
    teacherSession.value = OPEN;
    expect(await loadTeacherSession()).toEqual(OPEN);
    expect(early).not.toHaveBeenCalled();
    expect(now).toHaveBeenCalledOnce();
  });
});
