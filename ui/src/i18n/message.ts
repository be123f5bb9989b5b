/** What went wrong and what to do about it, with gaps such as `{value}`. */
export interface Message {
  readonly message: string;
  readonly remedy: string;
}

/** Messages of the server by their codes. */
export type Catalogue = Readonly<Record<string, Message>>;

/** Blockly's own words by its keys. */
export type BlocklyMessages = Readonly<Record<string, string>>;
