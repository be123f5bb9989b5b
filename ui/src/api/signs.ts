import { del, get, post, put } from "./client";

const ofClass = (id: string, sign: string) => ({ params: { path: { id, sign } } });

/** Requests about the signs that a class teaches the camera. */
export const signsApi = {
  /** Makes the camera recognise the signs of a class; gives the letters and these signs. */
  use: async (classroom: string | null) =>
    (await put("/api/camera/classroom", { body: { classroom_id: classroom } })).signs,
  /** The letters and the signs of a class. */
  list: async (classroom: string) =>
    (await get("/api/classrooms/{id}/signs", { params: { path: { id: classroom } } })).signs,
  /** Starts to record samples from the camera; events report the progress. */
  record: (classroom: string, sign: string) =>
    post("/api/classrooms/{id}/signs/{sign}/samples", ofClass(classroom, sign)),
  /** Starts to record movements, each from rest to rest. */
  recordMoving: (classroom: string, sign: string) =>
    post("/api/classrooms/{id}/signs/{sign}/movements", ofClass(classroom, sign)),
  stop: () => del("/api/signs/recording"),
  /** Deletes the recorded samples of a sign; an event reports that the list has changed. */
  forget: (classroom: string, sign: string) =>
    del("/api/classrooms/{id}/signs/{sign}", ofClass(classroom, sign)),
};
