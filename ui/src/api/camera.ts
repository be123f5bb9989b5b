import { get, post, put } from "./client";

/** Requests about the camera that recognises signs; its results come as events. */
export const cameraApi = {
  status: () => get("/api/camera"),
  choose: (source: string) => put("/api/camera", { body: { source } }),
  /** Starts the camera process so that it is ready to recognise signs; the camera stays off. */
  warmUp: () => post("/api/camera/wake"),
};

/**
 * The address of the mirrored live picture; a request for it keeps the camera on. Another number
 * makes the browser request it again.
 */
export const previewAddress = (attempt: number) => `/api/camera/preview?attempt=${attempt}`;
