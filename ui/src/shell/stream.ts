import type { StreamEvent } from "../api/model";

interface Listener {
  onEvent(event: StreamEvent): void;
  /** The line to the server broke; it is being tried again. */
  onLost(): void;
}

const AGAIN_MS = 1500;

/** The page's one event stream. Comes back by itself; after each return the server says `hello`. */
export function openStream({ onEvent, onLost }: Listener): () => void {
  let source: EventSource | null = null;
  let timer = 0;
  const open = () => {
    source = new EventSource("/api/stream");
    source.onmessage = (message) => onEvent(JSON.parse(message.data) as StreamEvent);
    source.onerror = () => {
      onLost();
      // an answer such as 401 ends an EventSource for good; a broken line does not
      if (source?.readyState === EventSource.CLOSED) timer = window.setTimeout(open, AGAIN_MS);
    };
  };
  open();
  return () => {
    window.clearTimeout(timer);
    source?.close();
  };
}
