import { UsersRound } from "lucide-preact";
import { isPicture, PICTURES } from "./pictures";

interface GroupPictureProps {
  name: string;
  class?: string;
}

/** A group's picture, or a general icon: groups of earlier releases have no picture. */
export function GroupPicture({ name, class: extra = "" }: GroupPictureProps) {
  const Drawing = isPicture(name) ? PICTURES[name] : UsersRound;
  return <Drawing class={`icon ${extra}`} aria-hidden="true" />;
}
