import type { StreamEvent } from "../api/model";

interface Listener {
  onEvent(event: StreamEvent): void;
  /** The connection to the server was lost; the stream reconnects. */
  onLost(): void;
}

const AGAIN_MS = 1500;

/** The page's event stream. It reconnects automatically; after each reconnection the server sends `hello`. */
export function openStream({ onEvent, onLost }: Listener): () => void {
  let source: EventSource | null = null;
  let timer = 0;
  const open = () => {
    source = new EventSource("/api/stream");
    source.onmessage = (message) => onEvent(JSON.parse(message.data) as StreamEvent);
    source.onerror = () => {
      onLost();
      // a response such as 401 closes an EventSource permanently; a lost connection does not
      if (source?.readyState === EventSource.CLOSED) timer = window.setTimeout(open, AGAIN_MS);
    };
  };
  open();
  return () => {
    window.clearTimeout(timer);
    source?.close();
  };
}
