//! Saved states for `serde`, with the feature of that name: written by hand, because derived code knows arrays of up to 32 entries only.
//!
//! A struct of `version`, `fingerprint`, `time`, `q`, `v` and `z`, whose lists are sequences of known lengths, so that formats which tell
//! no names (postcard, bincode) take no more room than the numbers. Whether a state belongs to a mechanism is asked where it is restored.

use super::Saved;
use core::fmt::{self, Formatter};
use core::marker::PhantomData;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeStruct, SerializeTuple, Serializer};

const NAME: &str = "Saved";
const FIELDS: &[&str] = &["version", "fingerprint", "time", "q", "v", "z"];

/// A list of known length; implemented for arrays and for nothing.
pub trait Entries<R>: Sized {
    /// Its entries.
    fn entries(&self) -> &[R];
    /// The list of what `next` gives; the error tells how many there were.
    ///
    /// # Errors
    /// What `next` says, or that it ended too soon.
    fn filled<E>(next: impl FnMut() -> Result<Option<R>, E>) -> Result<Self, Unfilled<E>>;
    /// How many it has.
    const COUNT: usize;
}

/// Why a list is not filled.
pub enum Unfilled<E> {
    /// There were only so many.
    Short(usize),
    /// Reading failed.
    Failed(E),
}

impl<R: Copy + Default, const N: usize> Entries<R> for [R; N] {
    const COUNT: usize = N;

    fn entries(&self) -> &[R] {
        self
    }

    fn filled<E>(mut next: impl FnMut() -> Result<Option<R>, E>) -> Result<Self, Unfilled<E>> {
        let mut list = [R::default(); N];
        for (index, entry) in list.iter_mut().enumerate() {
            *entry = next().map_err(Unfilled::Failed)?.ok_or(Unfilled::Short(index))?;
        }
        Ok(list)
    }
}

impl<R> Entries<R> for () {
    const COUNT: usize = 0;

    fn entries(&self) -> &[R] {
        &[]
    }

    fn filled<E>(_: impl FnMut() -> Result<Option<R>, E>) -> Result<Self, Unfilled<E>> {
        Ok(())
    }
}

/// A list as a tuple of its entries.
struct List<'l, R>(&'l [R]);

impl<R: Serialize> Serialize for List<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0.iter().try_for_each(|entry| tuple.serialize_element(entry))?;
        tuple.end()
    }
}

/// A list that was read.
struct Read<T, R>(T, PhantomData<R>);

impl<'de, R: Deserialize<'de>, T: Entries<R>> Deserialize<'de> for Read<T, R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reading<T, R>(PhantomData<(T, R)>);

        impl<'de, R: Deserialize<'de>, T: Entries<R>> Visitor<'de> for Reading<T, R> {
            type Value = Read<T, R>;

            fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
                write!(f, "{} numbers", T::COUNT)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
                match T::filled(|| entries.next_element()) {
                    Ok(list) => Ok(Read(list, PhantomData)),
                    Err(Unfilled::Failed(error)) => Err(error),
                    Err(Unfilled::Short(count)) => Err(Error::invalid_length(count, &self)),
                }
            }
        }

        deserializer.deserialize_tuple(T::COUNT, Reading(PhantomData))
    }
}

impl<Q, V, Z, R> Serialize for Saved<Q, V, Z, (), R>
where
    Q: Entries<R>,
    V: Entries<R>,
    Z: Entries<R>,
    R: Serialize,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct(NAME, FIELDS.len())?;
        fields.serialize_field("version", &self.version)?;
        fields.serialize_field("fingerprint", &self.fingerprint)?;
        fields.serialize_field("time", &List(&self.time))?;
        fields.serialize_field("q", &List(self.q.entries()))?;
        fields.serialize_field("v", &List(self.v.entries()))?;
        fields.serialize_field("z", &List(self.z.entries()))?;
        fields.end()
    }
}

/// A field by its name or number; others are passed over.
struct Field(usize);

impl<'de> Deserialize<'de> for Field {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Name;

        impl Visitor<'_> for Name {
            type Value = Field;

            fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a field")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Field, E> {
                Ok(Field(FIELDS.iter().position(|field| *field == name).unwrap_or(FIELDS.len())))
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<Field, E> {
                Ok(Field(usize::try_from(number).unwrap_or(FIELDS.len())))
            }
        }

        deserializer.deserialize_identifier(Name)
    }
}

impl<'de, Q, V, Z, R> Deserialize<'de> for Saved<Q, V, Z, (), R>
where
    Q: Entries<R>,
    V: Entries<R>,
    Z: Entries<R>,
    R: Deserialize<'de> + Copy + Default,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_struct(NAME, FIELDS, Fields(PhantomData))
    }
}

struct Fields<Q, V, Z, R>(PhantomData<(Q, V, Z, R)>);

impl<'de, Q, V, Z, R> Visitor<'de> for Fields<Q, V, Z, R>
where
    Q: Entries<R>,
    V: Entries<R>,
    Z: Entries<R>,
    R: Deserialize<'de> + Copy + Default,
{
    type Value = Saved<Q, V, Z, (), R>;

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("a saved state")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut fields: A) -> Result<Self::Value, A::Error> {
        fn next<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(
            fields: &mut A,
            index: usize,
        ) -> Result<T, A::Error> {
            fields.next_element()?.ok_or_else(|| Error::invalid_length(index, &"six fields"))
        }
        let (version, fingerprint) = (next(&mut fields, 0)?, next(&mut fields, 1)?);
        let Read(time, _): Read<[R; 3], R> = next(&mut fields, 2)?;
        let (Read(q, _), Read(v, _)): (Read<Q, R>, Read<V, R>) =
            (next(&mut fields, 3)?, next(&mut fields, 4)?);
        let Read(z, _): Read<Z, R> = next(&mut fields, 5)?;
        Ok(Saved { version, fingerprint, time, q, v, z, gates: () })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let (mut version, mut fingerprint) = (None, None);
        let (mut time, mut q, mut v, mut z) = (None, None, None, None);
        while let Some(Field(index)) = map.next_key()? {
            match index {
                0 => version = Some(map.next_value()?),
                1 => fingerprint = Some(map.next_value()?),
                2 => time = Some(map.next_value::<Read<[R; 3], R>>()?.0),
                3 => q = Some(map.next_value::<Read<Q, R>>()?.0),
                4 => v = Some(map.next_value::<Read<V, R>>()?.0),
                5 => z = Some(map.next_value::<Read<Z, R>>()?.0),
                _ => {
                    map.next_value::<serde::de::IgnoredAny>()?;
                }
            }
        }
        Ok(Saved {
            version: version.ok_or_else(|| Error::missing_field("version"))?,
            fingerprint: fingerprint.ok_or_else(|| Error::missing_field("fingerprint"))?,
            time: time.ok_or_else(|| Error::missing_field("time"))?,
            q: q.ok_or_else(|| Error::missing_field("q"))?,
            v: v.ok_or_else(|| Error::missing_field("v"))?,
            z: z.ok_or_else(|| Error::missing_field("z"))?,
            gates: (),
        })
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::string::ToString;

    type Kept = Saved<[f64; 40], [f64; 2], (), (), f64>;

    fn kept() -> Kept {
        let q = core::array::from_fn(|index| index as f64 + 0.1);
        Saved {
            version: 1,
            fingerprint: u64::MAX,
            time: [0.1, 1e-20, 0.0],
            q,
            v: [-0.0, 1.0 / 3.0],
            z: (),
            gates: (),
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let text = serde_json::to_string(&kept()).unwrap();
        assert!(
            text.starts_with("{\"version\":1,\"fingerprint\":18446744073709551615,\"time\":[0.1,"),
            "{text}"
        );
        let read: Kept = serde_json::from_str(&text).unwrap();
        assert!(read == kept() && read.v[0].is_sign_negative());
        let with_more = text.replacen('{', "{\"note\":[1,{}],", 1);
        assert_eq!(serde_json::from_str::<Kept>(&with_more).unwrap(), kept());
        // Formats without names.
        let listed =
            serde_json::json!([1, u64::MAX, [0.1, 1e-20, 0.0], kept().q.to_vec(), [-0.0, 1.0 / 3.0], []]);
        assert_eq!(serde_json::from_value::<Kept>(listed).unwrap(), kept());
        let single: Saved<[f32; 1], [f32; 1], [f32; 2], (), f32> =
            serde_json::from_str(r#"{"z":[1,2],"v":[3],"q":[4],"time":[0,0,0],"fingerprint":5,"version":1}"#)
                .unwrap();
        assert_eq!((single.q, single.z), ([4.0], [1.0, 2.0]));
    }

    #[test]
    fn what_does_not_fit_is_told() {
        let text = serde_json::to_string(&kept()).unwrap();
        let fails = |text: &str| serde_json::from_str::<Kept>(text).unwrap_err().to_string();
        assert!(fails(&text.replace(",39.1]", "]")).starts_with("invalid length 39, expected 40 numbers"));
        assert!(!fails(&text.replace(",39.1]", ",39.1,4.0]")).is_empty());
        assert!(fails(&text.replace("\"v\":", "\"w\":")).starts_with("missing field `v`"));
        assert!(fails(&text.replace("[0.1,", "[null,")).contains("invalid type: null"));
        assert!(fails("[1]").starts_with("invalid length 1, expected six fields"));
    }
}
