import { fetchPart } from "../shell/later";
import { parse, ROUTES } from "../shell/route";
import { connection } from "../shell/session";

/** Prefetches the screen of a link when the pointer or the focus reaches it. */
function fetchAhead({ target }: Event): void {
  const link =
    target instanceof Element ? target.closest<HTMLAnchorElement>("a[href^='#/']") : null;
  const load = link && ROUTES[parse(link.hash).screen].load;
  // not while offline: a browser may cache the failure of an import
  if (load && connection.peek() === "open") fetchPart(load).catch(() => {});
}

document.addEventListener("pointerover", fetchAhead);
document.addEventListener("focusin", fetchAhead);
