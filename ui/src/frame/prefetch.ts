import { fetchPart } from "../shell/lazy";
import { parse } from "../shell/route";
import { connection } from "../shell/session";
import { LOADS } from "./screens";

/** Prefetches the screen of a link when the pointer or the focus reaches it. */
function prefetchScreen({ target }: Event): void {
  const link =
    target instanceof Element ? target.closest<HTMLAnchorElement>("a[href^='#/']") : null;
  const load = link && LOADS[parse(link.hash).screen];
  // not while offline: a browser may cache a failed import
  if (load && connection.peek() === "open") fetchPart(load).catch(() => {});
}

document.addEventListener("pointerover", prefetchScreen);
document.addEventListener("focusin", prefetchScreen);
