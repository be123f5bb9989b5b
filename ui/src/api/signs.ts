import { del, get, post, put } from "./client";

const ofClass = (id: string, sign: string) => ({ params: { path: { id, sign } } });

/** Signs that a class teaches the camera. */
export const signsApi = {
  /** The camera knows what the class taught from now on; gives the letters and what it taught. */
  use: async (classroom: string | null) =>
    (await put("/api/camera/classroom", { body: { classroom_id: classroom } })).signs,
  /** The letters and what the class taught. */
  list: async (classroom: string) =>
    (await get("/api/classrooms/{id}/signs", { params: { path: { id: classroom } } })).signs,
  /** Begins to record what the camera sees; events tell how it goes on. */
  record: (classroom: string, sign: string) =>
    post("/api/classrooms/{id}/signs/{sign}/samples", ofClass(classroom, sign)),
  /** Begins to record movements, each from rest to rest. */
  recordMoving: (classroom: string, sign: string) =>
    post("/api/classrooms/{id}/signs/{sign}/movements", ofClass(classroom, sign)),
  stop: () => del("/api/signs/recording"),
  /** Deletes what was recorded; an event tells that the list is another one. */
  forget: (classroom: string, sign: string) =>
    del("/api/classrooms/{id}/signs/{sign}", ofClass(classroom, sign)),
};
