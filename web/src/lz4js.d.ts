declare module "lz4js" {
  export function decompress(frame: Uint8Array, longest?: number): Uint8Array;
}
