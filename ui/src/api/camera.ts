import { get, post, put } from "./client";

/** The camera that sees signs; what it sees comes with the events. */
export const cameraApi = {
  status: () => get("/api/camera"),
  choose: (source: string) => put("/api/camera", { body: { source } }),
  /** Gets ready to recognise signs; the camera itself stays off. */
  warmUp: () => post("/api/camera/wake"),
};

/** Where the mirrored picture is, which keeps the camera on; another number asks for it anew. */
export const previewAddress = (attempt: number) => `/api/camera/preview?attempt=${attempt}`;
